using GTA.Hosting;
using GTA.Math;
using GTA.Native;
using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>
/// A game behind the stand-in: a player, entities, scripted cameras and models that load after some ticks. It answers the natives as
/// their names promise, refuses those it does not know, and fails where a test tells it to.
/// </summary>
internal sealed partial class TestGame : IGameHost
{
    public const int Player = 999_999;
    private const int MillisecondsOfAFrame = 50;
    private readonly Dictionary<Hash, Func<object[], object?>> _natives = [];
    private readonly Dictionary<int, int> _ticksUntilLoaded = [];
    private int _lastHandle = 1_000_000;

    public TestGame(string folder)
    {
        ScriptFile = Path.Combine(folder, "GtaDataHarvester.dll");
        Entities[Player] = new GameEntity { Pool = PoolKind.Peds, Name = "player_zero", Pose = new Pose(new Vector3D(10, 20, 30), Axes.FromHeading(90)) };
        AddEntityNatives();
        AddVehicleNatives();
        AddObjectNatives();
        AddCameraNatives();
        AddRayNatives();
        AddRoadNatives();
        AddControlNatives();
        AddInterfaceNatives();
    }

    public string ScriptFile { get; }

    public int GameVersion { get; set; } = 86;

    public Dictionary<int, GameEntity> Entities { get; } = [];

    public int PlayersVehicle { get; set; }

    public bool IsPaused { get; private set; }

    public int Frame { get; set; }

    public int TimerMilliseconds { get; set; }

    public List<string> Notifications { get; } = [];

    public List<Hash> Calls { get; } = [];

    /// <summary>What to throw instead of answering a native; null to answer.</summary>
    public Func<Hash, Exception?> Fault { get; set; } = _ => null;

    /// <summary>What happens after the handles of what is near were listed, before they are read.</summary>
    public Action AfterListing { get; set; } = () => { };

    /// <summary>A list of handles needs free places in the pool of script handles.</summary>
    public bool ScriptHandlePoolIsFull { get; set; }

    /// <summary>What a frame brings, paused or not; null for a world in which only time passes.</summary>
    public Action? PassFrame { get; set; }

    /// <summary>Who must know when the world is stopped or goes on.</summary>
    public Action<bool> PauseChanged { get; set; } = _ => { };

    public IEnumerable<GameEntity> Vehicles => Entities.Values.Where(entity => entity.Pool == PoolKind.Vehicles);

    public int Add(GameEntity entity)
    {
        Entities[++_lastHandle] = entity;
        return _lastHandle;
    }

    public int HandleOf(GameEntity wanted) => Entities.Single(entity => entity.Value == wanted).Key;

    public void NextFrame()
    {
        Frame++;
        foreach (int model in _ticksUntilLoaded.Keys)
        {
            _ticksUntilLoaded[model]--;
        }

        TimerMilliseconds += IsPaused ? 0 : MillisecondsOfAFrame;
        PassFrame?.Invoke();
        PassControls();
        ClearDrawings();
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

    public int[] HandlesNear(PoolKind pool, Vector3 position, float radius, int[] models)
    {
        if (ScriptHandlePoolIsFull)
        {
            throw new InvalidOperationException("The fwScriptGuid pool is full.");
        }

        int[] near = Entities
            .Where(entity => entity.Value.Pool == pool && (models.Length == 0 || models.Contains(entity.Value.Model)))
            .Where(entity => (entity.Value.Pose.Position - new Vector3D(position.X, position.Y, position.Z)).Length < radius)
            .Select(entity => entity.Key)
            .ToArray();
        AfterListing();
        return near;
    }

    public void Notify(string message) => Notifications.Add(message);

    private static Vector3 ToGame(Vector3D vector) => new((float)vector.X, (float)vector.Y, (float)vector.Z);

    private static Vector3D ToWorld(object x, object y, object z) => new((float)x, (float)y, (float)z);

    private static void Write(object place, object value) => ((OutputArgument)place).Value = value;

    private void Do(Hash native, Action<object[]> act) => _natives[native] = a =>
    {
        act(a);
        return null;
    };
}
