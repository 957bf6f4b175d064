using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Features;
using Harvester.Play.Plans;
using Harvester.Play.Setup;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;

namespace Harvester.Mod;

/// <summary>The running game behind the ports of the features.</summary>
internal sealed class ScriptGame : IGameAdapters
{
    private readonly GameRays _rays = new();
    private readonly GameModels _models = new();
    private readonly NearbyEntities _nearby;

    /// <summary>Makes the adapters; the game is not used yet.</summary>
    /// <param name="build">Edition and build of the game.</param>
    /// <param name="messages">Shows which lists of the API have failed.</param>
    public ScriptGame(GameBuild build, PlayerMessages messages)
    {
        Calls = new GameCalls(_rays);
        Cameras = new GameCameras(build);
        _nearby = new NearbyEntities(build, new NativeLists(Time, _rays), Reading, messages);
        ShownEntities = new GameShownEntities(_nearby);
        Stage = new GameStage(_models, _rays);
    }

    /// <inheritdoc/>
    public IDisplay Display { get; } = new GameDisplay();

    /// <inheritdoc/>
    public IHudSwitch Hud { get; } = new GameHud();

    /// <inheritdoc/>
    public GameTime Time { get; } = new(GameFreeze.Set, static () => Natives.Call<int>(Hash.GET_GAME_TIMER));

    /// <inheritdoc/>
    public ISurfaceRays Rays => _rays;

    /// <inheritdoc/>
    public ICallCounter Calls { get; }

    /// <inheritdoc/>
    public ReadingRecord Reading { get; } = new();

    /// <inheritdoc/>
    public IVehicles Vehicles { get; } = new GameVehicles();

    /// <inheritdoc/>
    public IModels Models => _models;

    /// <inheritdoc/>
    public ICameras Cameras { get; }

    /// <inheritdoc/>
    public IShownEntities ShownEntities { get; }

    /// <inheritdoc/>
    public ICarControls Controls { get; } = new GameCarControls();

    /// <inheritdoc/>
    public ITrafficLights TrafficLights { get; } = new GameTrafficLights();

    /// <inheritdoc/>
    public IRoadSource Roads { get; } = new GameRoadSource();

    /// <inheritdoc/>
    public ITrialGame Trials { get; } = new GameTrials();

    /// <inheritdoc/>
    public IActorGame Actors { get; } = new GameActors();

    /// <inheritdoc/>
    public ISurveyStage Stage { get; }

    /// <inheritdoc/>
    public Vector3D PlayerPosition => Natives.EntityPosition(Natives.PlayerPed());

    /// <inheritdoc/>
    public GameScene SceneAround(CameraMount mount, Func<FaceTable> faces, Func<bool> looksAround)
    {
        var world = new GameWorld(mount, Time, _rays, _models, faces, _nearby, Reading) { LooksAround = looksAround };
        return new GameScene(world, world, new GameSight(mount, world));
    }
}
