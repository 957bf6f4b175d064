using GTA.Hosting;
using GTA.Math;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games.Natives;

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
    private readonly HashSet<int> _made = [];
    private NativeConvention _convention = new(sizeof(int));
    private int _lastHandle = 1_000_000;

    public TestGame(string folder)
    {
        ScriptFile = Path.Combine(folder, "GtaDataHarvester.dll");
        Entities[Player] = new GameEntity
        {
            Pool = PoolKind.Peds,
            Name = "player_zero",
            Pose = new Pose(new Vector3D(10, 20, 30), Axes.FromHeading(90)),
        };
        AddEntityNatives();
        AddVehicleNatives();
        AddObjectNatives();
        AddCameraNatives();
        AddRayNatives();
        AddRoadNatives();
        AddControlNatives();
        AddInterfaceNatives();
        AddListNatives();
        AddFreezeNatives();
        AddTrialNatives();
        AddActorNatives();
    }

    public string ScriptFile { get; }

    public GameBuild Build { get; set; } = Legacy(3179);

    public Dictionary<int, GameEntity> Entities { get; } = [];

    public int PlayersVehicle { get; set; }

    public int Frame { get; set; }

    public int TimerMilliseconds { get; set; }

    public List<string> Notifications { get; } = [];

    public List<Hash> Calls { get; } = [];

    /// <summary>Misuses by the script that the real API or the real game would not tolerate.</summary>
    public HashSet<string> Misuses { get; } = [];

    /// <summary>How many bytes natives write for a BOOL: 1, 4 or 8.</summary>
    public int BoolBytes
    {
        set => _convention = new NativeConvention(value);
    }

    /// <summary>What to throw instead of answering a native; null to answer.</summary>
    public Func<Hash, Exception?> Fault { get; set; } = _ => null;

    /// <summary>What the natives give that answer with random bits; null where all answer rightly. They do nothing else.</summary>
    public Func<NativeSignature, Random?> Lies { get; set; } = _ => null;

    /// <summary>Called after the handles of nearby entities were listed, before they are read.</summary>
    public Action AfterListing { get; set; } = () => { };

    /// <summary>
    /// What a list of the API's gives in a build whose memory it cannot read, by throwing or being empty; null for what there is.
    /// </summary>
    public Func<PoolKind, int[]?>? BrokenList { get; set; }

    /// <summary>A list of handles needs free places in the pool of script handles.</summary>
    public bool ScriptHandlePoolIsFull { get; set; }

    /// <summary>What a frame brings, paused or not; null for a world in which only time passes.</summary>
    public Action? PassFrame { get; set; }

    public IEnumerable<GameEntity> Vehicles => Entities.Values.Where(entity => entity.Pool == PoolKind.Vehicles);

    public static GameBuild Legacy(int build) => new("GTA5.exe", new Version(1, 0, build, 0));

    /// <summary>What a script that has ended should have given back.</summary>
    public IEnumerable<string> LeftBehind =>
        [
            .. _made.Where(Entities.ContainsKey).Select(handle => $"entity {Entities[handle].Name}"),
            .. Cameras.Select(camera => $"camera {camera.Key}"),
            .. RenderingCamera != NoCamera ? ["the view"] : Array.Empty<string>(),
            .. IsPaused ? ["the pause"] : Array.Empty<string>(),
            .. TimeScale != 1 ? ["the time scale"] : Array.Empty<string>(),
            .. KeptWeather is not null ? ["the weather"] : Array.Empty<string>(),
            .. IsSceneHeld ? ["a loaded scene"] : Array.Empty<string>(),
            .. IsPlayerInvincible || IsIgnoredByPolice ? ["the player's protection"] : Array.Empty<string>(),
            .. IsDrivenByTask ? ["the player's task"] : Array.Empty<string>(),
            .. _ticksUntilLoaded.Select(model => $"model {model.Key}"),
            .. LightOverrides.Select(light => $"traffic light {light.Key}"),
            .. IsRadarOn ? Array.Empty<string>() : ["the radar"],
            .. IsHudOn ? Array.Empty<string>() : ["the HUD"],
            .. Entities.Values.Where(entity => entity.IsHidden).Select(entity => $"hidden entity {entity.Name}"),
        ];

    public int Add(GameEntity entity)
    {
        Entities[++_lastHandle] = entity;
        return _lastHandle;
    }

    public int HandleOf(GameEntity wanted) => Entities.Single(entity => entity.Value == wanted).Key;

    /// <summary>Takes an entity out of the world.</summary>
    public void Remove(int handle)
    {
        Entities.Remove(handle);
        _made.Remove(handle);
    }

    public void NextFrame()
    {
        Frame++;
        foreach (int model in _ticksUntilLoaded.Keys)
        {
            _ticksUntilLoaded[model]--;
        }

        TimerMilliseconds += IsFrozen ? 0 : MillisecondsOfAFrame;
        PassFrame?.Invoke();
        PassControls();
        ClearDrawings();
    }

    public void Call(NativeCall call)
    {
        Calls.Add(call.Native);
        if (Fault(call.Native) is { } fault)
        {
            throw fault;
        }

        if (!NativeTable.ByHash.TryGetValue((ulong)call.Native, out NativeSignature? native))
        {
            throw new NotSupportedException($"The native {call.Native} is not in ref/natives.csv.");
        }

        if (!_natives.TryGetValue(call.Native, out Func<object[], object?>? answer))
        {
            throw new NotSupportedException($"The test game has no native {call.Native}.");
        }

        Misuses.UnionWith(native.MistakesIn(call.Passed, call.Expected));
        if (Lies(native) is { } random)
        {
            _convention.WriteGarbage(native, call, random);
            return;
        }

        _convention.WriteResult(native, call, answer(_convention.ReadArguments(native, call)!));
    }

    public int[] HandlesNear(PoolKind pool, Vector3 position, float radius, int[] models)
    {
        if (BrokenList?.Invoke(pool) is { } broken)
        {
            return broken;
        }

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

    public void Notify(string message)
    {
        ReportMarkup(message);
        Notifications.Add(message);
    }

    /// <summary>What stands between two tildes, such as ~r~, changes a text and is not shown.</summary>
    private void ReportMarkup(string text)
    {
        if (text.Contains('~', StringComparison.Ordinal))
        {
            Report($"The text has the game's markup: {text}");
        }
    }

    public void Report(string fault) => Misuses.Add(fault);

    private int Make(GameEntity entity)
    {
        int handle = Add(entity);
        _made.Add(handle);
        return handle;
    }

    private static Vector3 ToGame(Vector3D vector) => new((float)vector.X, (float)vector.Y, (float)vector.Z);

    private static Vector3D ToWorld(object x, object y, object z) => new((float)x, (float)y, (float)z);

    private static void Write(object place, object value) => ((NativeAddress)place).Write(value);

    private void Do(Hash native, Action<object[]> act) =>
        _natives[native] = a =>
        {
            act(a);
            return null;
        };
}
