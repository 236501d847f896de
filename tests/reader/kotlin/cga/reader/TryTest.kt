package cga.reader

import cga.reader.run.Machine
import cga.reader.run.Sampler
import cga.reader.shader.Kind
import cga.reader.shader.Stage
import cga.reader.tape.Tape
import cga.testing.projectRoot
import org.junit.jupiter.api.Test
import kotlin.random.Random

class TryTest {
    @Test
    fun all() {
        val files = listOf("tests/submissions", "shaders").flatMap { projectRoot.resolve(it).walk() }.filter { it.extension in setOf("glsl", "vert", "frag") }
        var ok = 0
        val started = System.nanoTime()
        for (f in files) {
            val stage = if (f.name.contains("vert")) Stage.VERTEX else Stage.FRAGMENT
            when (val r = try { Reading.of(f.path, f.readText(), stage) } catch (e: Exception) { println("EXC ${f.path}"); e.printStackTrace(System.out); continue }) {
                is Reading.Done -> {
                    ok++
                    val m = Machine(r.shader)
                    val random = Random(1)
                    for (s in r.shader.uniforms + r.shader.inputs) if (s.kind == Kind.SAMPLER) m[s] = Sampler.constant(.5, .4, .3, 1.0) else m[s] = DoubleArray(s.size) { if (s.kind == Kind.FLOAT) random.nextDouble() else 1.0 }
                    val tape = Tape(r.shader)
                    val o = m.run(tape)
                    println("${f.parentFile.parentFile.parentFile.name}/${f.name} ${r.repairs} size ${r.shader.size} cells ${r.shader.initial.size} $o tape ${tape.size} " + r.shader.outputs.filter { it.size > 1 }.take(2).joinToString { it.name + m[it].asList() })
                }
                is Reading.Failed -> println("FAILED " + r.problems)
            }
        }
        println("$ok of ${files.size} in ${(System.nanoTime() - started) / 1e6} ms")
    }

    @Test
    fun speed() {
        val r = Reading.of("scene.frag", projectRoot.resolve("shaders/scene.frag").readText(), Stage.FRAGMENT) as Reading.Done
        val m = Machine(r.shader)
        val random = Random(1)
        for (s in r.shader.uniforms + r.shader.inputs) if (s.kind == Kind.SAMPLER) m[s] = Sampler.constant(.5, .4, .3, 1.0) else m[s] = DoubleArray(s.size) { if (s.kind == Kind.FLOAT) random.nextDouble() else 1.0 }
        val tape = Tape(r.shader)
        for (round in 0 until 8) {
            val t0 = System.nanoTime()
            repeat(5000) { m.run() }
            val t1 = System.nanoTime()
            repeat(5000) { m.run(tape) }
            val t2 = System.nanoTime()
            println("off ${5000 / ((t1 - t0) / 1e9)} on ${5000 / ((t2 - t1) / 1e9)} entries ${tape.size} results ${tape.results.size}")
        }
    }
}
