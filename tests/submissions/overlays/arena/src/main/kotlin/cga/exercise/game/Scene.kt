package cga.exercise.game

import cga.exercise.components.camera.FollowCamera
import cga.exercise.components.camera.TronCamera
import cga.exercise.components.effects.Hud
import cga.exercise.components.effects.Skybox
import cga.exercise.components.geometry.*
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL30.*
import kotlin.math.abs
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val tronShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    private val skybox = Skybox()
    private val hud = Hud()

    private val ground: Renderable
    private val motorrad: Renderable
    private val player: Player
    private val opponents: List<Opponent>
    private val walls: List<Wall>

    private val orbitCamera = TronCamera()
    private val followCamera: FollowCamera
    private var follow = false

    private val bikeLight: PointLight
    private val pointLights = ArrayList<PointLight>()
    private val spotLight: SpotLight

    private val groundColor = Vector3f(0.0f, 1.0f, 0.0f)
    private val bikeColor = Vector3f(1.0f, 1.0f, 1.0f)

    private var oldMouseX = 0.0
    private var firstMouse = true

    init {
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        // Boden
        val diff = texture("assets/textures/ground_diff.png")
        val emit = texture("assets/textures/ground_emit.png")
        val spec = texture("assets/textures/ground_spec.png")
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val groundMaterial = Material(diff, emit, spec, 60.0f, Vector2f(64.0f))
        ground = Renderable(mutableListOf(Mesh(obj.vertexData, obj.indexData, Cube.attributes, groundMaterial)))

        // Spieler
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        motorrad.scaleLocal(Vector3f(0.8f))
        player = Player(motorrad)

        // Gegner benutzen dieselben Meshes
        opponents = listOf(
            Opponent(Renderable(motorrad.meshes), Vector3f(1.0f, 0.15f, 0.1f), Vector3f(-8.0f, 0.0f, -7.0f), 3.5f, 0.8f),
            Opponent(Renderable(motorrad.meshes), Vector3f(1.0f, 0.8f, 0.1f), Vector3f(9.0f, 0.0f, 4.0f), 4.0f, -0.6f)
        )

        // Tore
        val wallMesh = Cube.create(Material(diff, emit, spec, 40.0f, Vector2f(3.0f, 1.0f)))
        walls = listOf(
            Wall(Renderable(mutableListOf(wallMesh)), Vector3f(1.0f, 0.4f, 0.0f), Vector3f(0.0f, 0.8f, -14.0f), Vector3f(5.0f, 0.0f, 0.0f), Vector3f(2.0f, 0.8f, 0.2f)),
            Wall(Renderable(mutableListOf(wallMesh)), Vector3f(0.5f, 0.2f, 1.0f), Vector3f(-12.0f, 0.8f, 5.0f), Vector3f(0.0f, 0.0f, 4.0f), Vector3f(0.2f, 0.8f, 2.0f))
        )
        for (o in opponents + walls) o.update(0.0f)

        // Kameras
        orbitCamera.parent = motorrad
        orbitCamera.rotateLocal(Math.toRadians(-28.0f), 0.0f, 0.0f)
        orbitCamera.translateLocal(Vector3f(0.0f, 0.0f, 4.5f))
        followCamera = FollowCamera(motorrad)

        // Lichter
        bikeLight = PointLight(Vector3f(0.0f, 1.7f, 0.0f), Vector3f(1.0f))
        bikeLight.parent = motorrad
        pointLights.add(bikeLight)
        for ((i, opponent) in opponents.withIndex()) {
            val light = PointLight(Vector3f(0.0f, 1.7f, 0.0f), Vector3f(opponents[i].color).mul(1.5f))
            light.parent = opponent.model
            pointLights.add(light)
        }
        pointLights.add(PointLight(Vector3f(-15.0f, 2.0f, -15.0f), Vector3f(0.5f, 1.0f, 7.0f)))
        pointLights.add(PointLight(Vector3f(15.0f, 2.0f, -15.0f), Vector3f(7.0f, 0.5f, 4.0f)))
        pointLights.add(PointLight(Vector3f(15.0f, 2.0f, 15.0f), Vector3f(0.5f, 6.0f, 6.0f)))

        spotLight = SpotLight(Vector3f(0.0f, 1.0f, -1.8f), Vector3f(2.2f, 2.2f, 2.0f), Math.toRadians(13.0f), Math.toRadians(24.0f))
        spotLight.rotateLocal(Math.toRadians(-9.0f), 0.0f, 0.0f)
        spotLight.parent = motorrad

        GLError.checkThrow("init")
    }

    private fun texture(path: String): Texture2D {
        val texture = Texture2D(path, true)
        texture.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        return texture
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        val camera = if (follow) followCamera else orbitCamera

        bikeColor.set(0.55f + 0.45f * sin(t), 0.55f + 0.45f * sin(t + 2.0f), 0.55f + 0.45f * sin(t + 4.0f))
        bikeLight.lightColor = bikeColor

        tronShader.use()
        camera.bind(tronShader)
        for (i in pointLights.indices) pointLights[i].bind(tronShader, "pointLights[$i]")
        spotLight.bind(tronShader, "spot", camera.getCalculateViewMatrix())

        tronShader.setUniform("farbe", groundColor)
        ground.render(tronShader)
        for (wall in walls) {
            tronShader.setUniform("farbe", wall.color)
            wall.model.render(tronShader)
        }
        tronShader.setUniform("farbe", bikeColor)
        motorrad.render(tronShader)
        for (opponent in opponents) {
            tronShader.setUniform("farbe", opponent.color)
            opponent.model.render(tronShader)
        }

        skybox.render(camera)
        hud.render(abs(player.speed) / Player.MAX_SPEED, player.energy)
    }

    fun update(dt: Float, t: Float) {
        for (o in opponents) o.update(t)
        for (w in walls) w.update(t)
        player.update(window, dt, opponents + walls)
        followCamera.update(dt)
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_C && action == GLFW_PRESS) follow = !follow
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            oldMouseX = xpos
            firstMouse = false
        }
        val deltaX = oldMouseX - xpos
        oldMouseX = xpos
        if (!follow) orbitCamera.rotateAroundPoint(0.0f, (deltaX * 0.002).toFloat(), 0.0f, Vector3f(0.0f))
    }

    fun cleanup() {
        ground.cleanup()
        motorrad.cleanup()
        walls.first().model.cleanup()
        skybox.cleanup()
        hud.cleanup()
        tronShader.cleanup()
    }
}
