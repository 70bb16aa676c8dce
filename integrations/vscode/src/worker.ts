/** Thread that answers requests by the module. */
import { parentPort } from "node:worker_threads";
import * as polhode from "polhode";
import { defect, type Message, type Outcome } from "./pool";

parentPort!.on("message", ({ name, request }: Message) => {
  void answer(name, request).then((outcome) => parentPort!.postMessage(outcome));
});

async function answer(name: Message["name"], request: never): Promise<Outcome<unknown>> {
  try {
    return { value: await polhode[name](request) };
  } catch (problem) {
    return { failures: problem instanceof polhode.PolhodeError ? problem.failures : [defect(problem)] };
  }
}
