using GTA.Hosting;
using GTA.Math;
using GTA.Native;
using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>
/// A small game behind the stand-in: a player, entities, scripted cameras and models that load after some ticks. It answers the
/// natives as their names promise, refuses those it does not know, and fails where a test tells it to.
/// </summary>
internal sealed partial class TestGame : IGameHost
{
    public const int Player = 1;
    private const int FirstEntity = 100;
    private readonly Dictionary<Hash, Func<object[], object?>> _natives = [];
    private readonly Dictionary<int, int> _ticksUntilLoaded = [];
    private int _lastHandle = FirstEntity;

    public TestGame(string folder)
    {
        ScriptFile = Path.Combine(folder, "GtaDataHarvester.dll");
        Entities[Player] = new GameEntity { Pool = PoolKind.Peds, Model = 1, Pose = new Pose(new Vector3D(10, 20, 30), Axes.FromHeading(90)) };
        AddEntityNatives();
        AddVehicleNatives();
        AddCameraNatives();
        AddInterfaceNatives();
    }

    public string ScriptFile { get; }

    public int GameVersion { get; set; } = 86;

    public Dictionary<int, GameEntity> Entities { get; } = [];

    public Dictionary<int, GameCamera> Cameras { get; } = [];

    public int PlayersVehicle { get; set; }

    public int RenderingCamera { get; set; } = -1;

    public bool IsPaused { get; private set; }

    public bool ModelsLoad { get; set; } = true;

    public bool VehiclePoolIsFull { get; set; }

    public int Frame { get; private set; }

    public List<string> Notifications { get; } = [];

    public List<Hash> Calls { get; } = [];

    /// <summary>What to throw instead of answering a native; null to answer.</summary>
    public Func<Hash, Exception?> Fault { get; set; } = _ => null;

    /// <summary>The test cars are the vehicles that the script made.</summary>
    public IEnumerable<GameEntity> Vehicles => Entities.Values.Where(entity => entity.Pool == PoolKind.Vehicles);

    public int Add(GameEntity entity)
    {
        Entities[++_lastHandle] = entity;
        return _lastHandle;
    }

    public void NextFrame()
    {
        Frame++;
        foreach (int model in _ticksUntilLoaded.Keys)
        {
            _ticksUntilLoaded[model]--;
        }
    }

    public object? Call(Hash native, object[] arguments)
    {
        Calls.Add(native);
        if (Fault(native) is { } fault)
        {
            throw fault;
        }

        return _natives.TryGetValue(native, out Func<object[], object?>? answer)
            ? answer(arguments)
            : throw new NotSupportedException($"The test game has no native {native}.");
    }

    public int[] HandlesNear(PoolKind pool, Vector3 position, float radius, int[] models) => Entities
        .Where(entity => entity.Value.Pool == pool && (models.Length == 0 || models.Contains(entity.Value.Model)))
        .Where(entity => (entity.Value.Pose.Position - new Vector3D(position.X, position.Y, position.Z)).Length <= radius)
        .Select(entity => entity.Key)
        .ToArray();

    public void Notify(string message) => Notifications.Add(message);

    private static Vector3 ToGame(Vector3D vector) => new((float)vector.X, (float)vector.Y, (float)vector.Z);

    private static Vector3D ToWorld(object x, object y, object z) => new((float)x, (float)y, (float)z);
}
