package cga.exercise.game

import cga.exercise.engine.Emission
import cga.exercise.engine.Entity
import cga.exercise.engine.EventBus
import cga.exercise.engine.Frame
import cga.exercise.engine.Lamp
import cga.exercise.engine.MouseMoved
import cga.exercise.engine.Pulse
import cga.exercise.engine.Tick
import cga.framework.GameWindow
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import kotlin.math.sin

/** Colours what pulses, be it a body or a light. */
class PulseSystem(root: Entity, bus: EventBus) {
    init {
        bus.on<Frame> { frame ->
            root.walk { entity ->
                val pulse = entity.find<Pulse>() ?: return@walk
                val color = colorAt(frame.t, pulse.speeds)
                entity.find<Emission>()?.color?.set(color)
                entity.find<Lamp>()?.light?.color?.set(color)
            }
        }
    }

    private fun colorAt(t: Float, speeds: Vector3f) = Vector3f(
        0.6f + 0.4f * sin(speeds.x * t),
        0.6f + 0.4f * sin(speeds.y * t + 1.0f),
        0.6f + 0.4f * sin(speeds.z * t + 3.0f)
    )
}

/** Turns the boom with the mouse. */
class OrbitSystem(boom: Entity, bus: EventBus) {
    init {
        bus.on<MouseMoved> { boom.node.rotateLocal(0.0f, (it.dx * -0.002).toFloat(), 0.0f) }
    }
}

class DriveSystem(private val window: GameWindow, private val vehicle: Entity, bus: EventBus) {
    init {
        bus.on<Tick> { drive(it.dt) }
    }

    private fun drive(dt: Float) {
        val gas = pressed(GLFW_KEY_W) - pressed(GLFW_KEY_S)
        val steer = pressed(GLFW_KEY_A) - pressed(GLFW_KEY_D)
        vehicle.node.rotateLocal(0.0f, 1.4f * gas * steer * dt, 0.0f)
        vehicle.node.translateLocal(Vector3f(0.0f, 0.0f, -6.5f * gas * dt))
    }

    private fun pressed(key: Int) = if (window.getKeyState(key)) 1 else 0
}
