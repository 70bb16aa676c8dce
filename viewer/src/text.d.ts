/** A file as text, by esbuild's loader. */
declare module "*.txt" {
  const text: string;
  export default text;
}
