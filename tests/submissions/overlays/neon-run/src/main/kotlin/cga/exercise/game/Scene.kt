package cga.exercise.game

import cga.exercise.components.camera.OrbitCamera
import cga.exercise.components.effects.Sparks
import cga.exercise.components.effects.Trail
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shadow.ShadowMap
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.PI
import kotlin.math.sin
import kotlin.random.Random

class Scene(private val window: GameWindow) {
    private val shader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val random = Random(11)

    private val ground: Renderable
    private val bike: Renderable
    private val obstacles = mutableListOf<Renderable>()
    private val collectibles = mutableListOf<Collectible>()

    private val bikeLight = PointLight(Vector3f(0.0f, 1.7f, 0.4f), Vector3f(1.0f))
    private val headlight = SpotLight(Vector3f(0.0f, 0.9f, -1.95f), Vector3f(2.8f, 2.8f, 2.4f), toRadians(16.0f), toRadians(27.0f))
    private val lamps = listOf(
        PointLight(Vector3f(-13.0f, 2.0f, -13.0f), Vector3f(6.0f, 1.0f, 0.0f)),
        PointLight(Vector3f(13.0f, 2.0f, -13.0f), Vector3f(0.0f, 2.0f, 7.0f)),
        PointLight(Vector3f(-13.0f, 2.0f, 13.0f), Vector3f(5.0f, 0.0f, 6.0f))
    )

    private val chaseCamera: OrbitCamera
    private val helicopter: OrbitCamera
    private var camera: OrbitCamera

    private val shadows = ShadowMap(Vector3f(0.4f, 1.0f, 0.5f).normalize())
    private val trail: Trail
    private val sparks = Sparks()

    private var speed = 0.0f
    private var score = 0
    private var mouseX: Double? = null

    init {
        glClearColor(FOG.x, FOG.y, FOG.z, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        val diff = texture("ground_diff")
        val emit = texture("ground_emit")
        val spec = texture("ground_spec")

        val groundObj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val groundMesh = Mesh(groundObj.vertexData, groundObj.indexData, Shapes.ATTRIBUTES, Material(diff, emit, spec, 60.0f, Vector2f(128.0f)))
        ground = Renderable(mutableListOf(groundMesh), Vector3f(0.0f, 1.0f, 0.0f))
        ground.scaleLocal(Vector3f(3.0f, 1.0f, 3.0f))

        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f) ?: error("no motorcycle")
        bike.scaleLocal(Vector3f(0.8f))
        bikeLight.parent = bike
        headlight.parent = bike
        headlight.rotateLocal(toRadians(-9.0f), 0.0f, 0.0f)

        chaseCamera = OrbitCamera(bike, 5.0f, 3.0f)
        helicopter = OrbitCamera(bike, 7.0f, 14.0f)
        camera = chaseCamera
        trail = Trail(bike)

        // pillars in a ring, far enough from the start
        val pillar = Shapes.box(Material(diff, emit, spec, 30.0f, Vector2f(2.0f)))
        for (i in 0 until 9) {
            val angle = 2.0f * PI.toFloat() * i / 9.0f
            val obstacle = Renderable(mutableListOf(pillar), Vector3f(0.1f, 0.4f, 1.0f))
            obstacle.rotateLocal(0.0f, angle, 0.0f)
            obstacle.translateLocal(Vector3f(0.0f, 1.2f, 17.0f))
            obstacle.scaleLocal(Vector3f(0.6f, 1.2f, 0.6f))
            obstacles.add(obstacle)
        }

        val ball = Shapes.sphere(Material(diff, emit, spec, 80.0f, Vector2f(3.0f)))
        val colors = listOf(Vector3f(1.0f, 0.8f, 0.0f), Vector3f(1.0f, 0.1f, 0.4f), Vector3f(0.2f, 1.0f, 0.9f))
        for (i in 0 until 8) collectibles.add(Collectible(ball, colors[i % 3], random))

        GLError.checkThrow("after the scene was built")
    }

    private fun texture(name: String): Texture2D {
        val texture = Texture2D("assets/textures/$name.png", true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    private fun wave(t: Float, phase: Float) = 0.55f + 0.45f * sin(1.2f * t + phase)

    fun render(dt: Float, t: Float) {
        bike.glow.set(wave(t, 0.0f), wave(t, 2.1f), wave(t, 4.2f))
        bikeLight.color = bike.glow

        shadows.record(window.framebufferWidth, window.framebufferHeight) { drawAll(it) }

        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        val view = camera.getCalculateViewMatrix()
        shader.use()
        camera.bind(shader)
        shadows.bind(shader, view)
        shader.setUniform("fogColor", FOG)
        shader.setUniform("fogStart", 48.0f)
        shader.setUniform("fogEnd", 85.0f)
        val pointLights = lamps + bikeLight
        pointLights.forEachIndexed { i, light -> light.bind(shader, "pointLights[$i]", view) }
        shader.setUniform("pointLightCount", pointLights.size)
        headlight.bind(shader, "spotLight", view)
        drawAll(shader)

        // blended things last
        trail.render(camera, bike.glow)
        sparks.render(camera)
    }

    private fun drawAll(with: ShaderProgram) {
        ground.render(with)
        bike.render(with)
        for (obstacle in obstacles) obstacle.render(with)
        for (collectible in collectibles) collectible.render(with)
    }

    fun update(dt: Float, t: Float) {
        drive(dt)
        trail.update()
        sparks.update(dt)
        for (collectible in collectibles) {
            collectible.fall(dt)
            if (collectible.getWorldPosition().distance(bike.getWorldPosition()) < 1.3f) {
                sparks.explode(collectible.getWorldPosition(), collectible.glow)
                collectible.drop()
                score++
                println("Score: $score")
            }
        }
    }

    private fun drive(dt: Float) {
        var wanted = 0.0f
        if (window.getKeyState(GLFW_KEY_W)) wanted += 8.0f
        if (window.getKeyState(GLFW_KEY_S)) wanted -= 4.0f
        speed += (wanted - speed) * minOf(1.0f, 5.0f * dt)
        var turn = 0.0f
        if (window.getKeyState(GLFW_KEY_A)) turn += 1.0f
        if (window.getKeyState(GLFW_KEY_D)) turn -= 1.0f
        bike.rotateLocal(0.0f, turn * 0.2f * speed * dt, 0.0f)

        bike.translateLocal(Vector3f(0.0f, 0.0f, -speed * dt))
        val crashed = obstacles.any { it.getWorldPosition().setComponent(1, 0.0f).distance(bike.getWorldPosition()) < 1.5f }
        if (crashed) {
            bike.translateLocal(Vector3f(0.0f, 0.0f, speed * dt))
            speed = 0.0f
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_V && action == GLFW_PRESS) {
            camera = if (camera == chaseCamera) helicopter else chaseCamera
        }
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        mouseX?.let { old -> camera.yaw += ((old - xpos) * 0.002).toFloat() }
        mouseX = xpos
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        obstacles.first().cleanup()
        collectibles.first().cleanup()
        trail.cleanup()
        sparks.cleanup()
        shadows.cleanup()
        shader.cleanup()
    }

    companion object {
        private val FOG = Vector3f(0.02f, 0.03f, 0.06f)
    }
}
