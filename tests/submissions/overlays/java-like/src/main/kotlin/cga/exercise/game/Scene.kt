package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.UniformSender
import cga.framework.GameWindow
import org.joml.Math
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW
import org.lwjgl.opengl.GL11

class Scene {

    private val window: GameWindow
    private val sender: UniformSender
    private val ground: Renderable
    private val motorcycle: Renderable
    private val camera: TronCamera
    private val motorcycleLight: PointLight
    private val lights: ArrayList<PointLight> = ArrayList<PointLight>()
    private val mouseTracker: MouseTracker = MouseTracker()

    constructor(window: GameWindow) {
        this.window = window
        this.sender = UniformSender(ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl"))
        this.ground = SceneFactory.createGround()
        this.ground.setOverlayColor(Vector3f(0.0f, 1.0f, 0.0f))
        this.motorcycle = SceneFactory.createMotorcycle()

        this.camera = TronCamera(Math.toRadians(90.0f), 16.0f / 9.0f)
        this.camera.parent = this.motorcycle
        this.camera.rotateLocal(Math.toRadians(-30.0f), 0.0f, 0.0f)
        this.camera.translateLocal(Vector3f(0.0f, 0.0f, 4.5f))

        this.motorcycleLight = PointLight(Vector3f(0.0f, 1.8f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f))
        this.motorcycleLight.parent = this.motorcycle
        val headlight = SpotLight(
            Vector3f(0.0f, 0.9f, -1.9f), Vector3f(3.0f, 3.0f, 3.0f),
            Math.toRadians(16.0f), Math.toRadians(24.0f)
        )
        headlight.rotateLocal(Math.toRadians(-9.0f), 0.0f, 0.0f)
        headlight.parent = this.motorcycle

        this.lights.add(this.motorcycleLight)
        this.lights.add(headlight)
        this.lights.addAll(SceneFactory.createCornerLights())

        GL11.glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        GL11.glEnable(GL11.GL_CULL_FACE)
        GL11.glEnable(GL11.GL_DEPTH_TEST)
    }

    fun render(dt: Float, t: Float) {
        GL11.glClear(GL11.GL_COLOR_BUFFER_BIT or GL11.GL_DEPTH_BUFFER_BIT)
        this.updateColor(t)
        this.sender.begin()
        this.sender.sendCamera(this.camera)
        this.sender.sendAmbient(Vector3f(0.02f, 0.02f, 0.02f))
        for (i in 0 until this.lights.size) {
            this.lights.get(i).bind(this.sender, i)
        }
        this.ground.render(this.sender)
        this.motorcycle.render(this.sender)
    }

    private fun updateColor(t: Float) {
        val red: Float = Math.abs(Math.sin(t * 0.9f))
        val green: Float = Math.abs(Math.sin(t * 0.6f + 1.0f))
        val blue: Float = Math.abs(Math.sin(t * 0.4f + 2.0f))
        val color = Vector3f(red, green, blue)
        this.motorcycle.setOverlayColor(color)
        this.motorcycleLight.setLightColor(color)
    }

    fun update(dt: Float, t: Float) {
        var speed: Float = 0.0f
        if (this.window.getKeyState(GLFW.GLFW_KEY_W)) {
            speed = 6.0f
        } else if (this.window.getKeyState(GLFW.GLFW_KEY_S)) {
            speed = -3.0f
        }
        var turn: Float = 0.0f
        if (this.window.getKeyState(GLFW.GLFW_KEY_A)) {
            turn = Math.toRadians(60.0f)
        } else if (this.window.getKeyState(GLFW.GLFW_KEY_D)) {
            turn = Math.toRadians(-60.0f)
        }
        if (speed != 0.0f) {
            this.motorcycle.rotateLocal(0.0f, turn * dt * Math.signum(speed), 0.0f)
            this.motorcycle.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        val angle: Float = (this.mouseTracker.moveTo(xpos) * 0.002).toFloat()
        this.camera.rotateAroundPoint(0.0f, -angle, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        this.ground.cleanup()
        this.motorcycle.cleanup()
        this.sender.getShaderProgram().cleanup()
    }
}
