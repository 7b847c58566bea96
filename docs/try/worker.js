// The program in a thread of its own: furnishing a room takes long enough to make a page stutter.
//
// A question is {number, method, values}, its answer {number, status, bytes}.
import { loadProgram } from './program.js';

const loaded = loadProgram('./roomwright.wasm');

self.addEventListener('message', async ({ data: { number, method, values } }) => {
  const { status, bytes } = await answered(method, values);
  self.postMessage({ number, status, bytes }, [bytes]);
});

async function answered(method, values) {
  try {
    return (await loaded)[method](...values);
  } catch (error) {
    return { status: 500, bytes: new TextEncoder().encode(`the program failed: ${error.message}`).buffer };
  }
}
