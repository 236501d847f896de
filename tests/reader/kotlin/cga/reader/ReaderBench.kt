package cga.reader

import cga.exercise.components.shader.ShaderSource
import cga.reader.run.Machine
import cga.reader.shader.Kind
import cga.reader.shader.Stage
import cga.reader.tape.Tape
import java.lang.management.ManagementFactory
import kotlin.random.Random

/**
 * How long it takes to read our own fragment shader, and how often a second it runs, by the time of one processor. Not a test; after the
 * tests were compiled:
 *
 *     java -cp CLASSPATH cga.reader.ReaderBenchKt
 */
internal fun main() {
    val text = ShaderSource.read("shaders/scene.frag").text
    repeat(ROUNDS) {
        val reading = perSecond(READINGS) { shader(text, Stage.FRAGMENT, "scene.frag") }
        val machine = Machine(shader(text, Stage.FRAGMENT, "scene.frag"))
        val random = Random(1)
        for (slot in machine.shader.uniforms + machine.shader.inputs) {
            if (slot.kind ==
                Kind.SAMPLER
            ) {
                machine[slot] = OneColor(doubleArrayOf(0.5, 0.4, 0.3, 1.0))
            } else {
                machine[slot] = random.numbersFor(slot)
            }
        }
        val tape = Tape(machine.shader)
        val without = perSecond(RUNS) { machine.run() }
        val with = perSecond(RUNS) { machine.run(tape) }
        println("read in %.1f ms; %.0f runs/s, %.0f with a tape of %d operations".format(1000 / reading, without, with, tape.size))
    }
}

private const val ROUNDS = 6
private const val READINGS = 20
private const val RUNS = 10_000

private fun perSecond(count: Int, action: () -> Unit): Double {
    val clock = ManagementFactory.getThreadMXBean()
    val start = clock.currentThreadCpuTime
    repeat(count) { action() }
    return count / ((clock.currentThreadCpuTime - start) / 1e9)
}
