declare module "*.txt" { const text: string; export default text; }
declare module "scenario.schema.json" { const schema: object; export default schema; }
