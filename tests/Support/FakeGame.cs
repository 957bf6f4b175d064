using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.TestSupport;

/// <summary>
/// A game of one car ahead of a driving camera, at 60 ticks a second. Its pictures hold, in their first bytes, the number of the
/// world's state that they show; the same number is the game time in ticks, so that a label can be held against its picture.
/// Quirks: the picture's lag, ticks until a freeze takes, a camera that is reported a frame late, and failures of any port.
/// </summary>
internal sealed class FakeGame : IWorld, IRayCaster, IScreen, IPause, IClock
{
    public const double TicksPerSecond = 60;

    private readonly List<long> _shown = [0];
    private IReadOnlyList<EntityState> _read = [];
    private bool _wantsFrozen;
    private int _ticksToFreeze;

    public GamePorts Ports => new(this, this, this, this, this);

    /// <summary>By how many ticks the picture is behind the state.</summary>
    public int PictureLag { get; set; }

    /// <summary>Ticks from the request to freeze until the world stands.</summary>
    public int FreezeDelay { get; set; }

    /// <summary>Whether the camera is reported as it was a tick ago.</summary>
    public bool CameraReportedLate { get; set; }

    /// <summary>Metres that traffic and camera move a tick.</summary>
    public double MetresPerTick { get; set; } = 0.25;

    /// <summary>Called at the start of each port's call with its name; throws to make a port fail.</summary>
    public Action<string> OnCall { get; set; } = static _ => { };

    /// <summary>What the screen answers.</summary>
    public GrabResult GrabAnswer { get; set; } = GrabResult.Good;

    /// <summary>Bytes of each picture, besides its number, that movement changes strongly.</summary>
    public int MovementBytes { get; set; }

    /// <summary>By how much the last byte of a picture changes from tick to tick whatever the world does.</summary>
    public byte Noise { get; set; }

    /// <summary>Milliseconds of the player's time that a ray takes.</summary>
    public double MillisecondsPerRay { get; set; }

    /// <summary>Changes what the world reports, entity by entity.</summary>
    public Func<IReadOnlyList<EntityState>, IReadOnlyList<EntityState>> Entities { get; set; } = static entities => entities;

    /// <summary>The ray caster; null (default) for the cuboids of the entities.</summary>
    public Func<Ray, double, int, RayHit?>? Rays { get; set; }

    /// <summary>The number of the world's state: it does not change while the world is frozen.</summary>
    public long State { get; private set; }

    public bool IsFrozen => _wantsFrozen && _ticksToFreeze == 0;

    public bool WantsFrozen => _wantsFrozen;

    public FreezeMethod Method { get; set; }

    public double Milliseconds { get; private set; }

    public long GameFrame { get; private set; }

    public double TimeSeconds => State / TicksPerSecond;

    /// <summary>The number of the state that a picture of this game shows.</summary>
    public static long StateOf(PixelBuffer picture) => BitConverter.ToInt64(picture.Bytes, 0);

    /// <summary>The number of the state at the game time of a label.</summary>
    public static long StateAt(double timeSeconds) => (long)Math.Round(timeSeconds * TicksPerSecond);

    /// <summary>Runs a session until it is over, at most a number of ticks; returns the phase after each.</summary>
    public IReadOnlyList<HarvestPhase> Run(HarvestSession session, int ticks = 10_000)
    {
        var phases = new List<HarvestPhase>();
        for (int tick = 0; tick < ticks && !session.Status.IsOver; tick++)
        {
            phases.Add(session.Step().Phase);
            Tick();
        }

        return phases;
    }

    /// <summary>Lets the game run without a harvest.</summary>
    public void RunAlone(int ticks)
    {
        for (int tick = 0; tick < ticks; tick++)
        {
            Tick();
        }
    }

    /// <summary>Lets the player's time pass within a tick.</summary>
    public void Work(double milliseconds) => Milliseconds += milliseconds;

    /// <summary>One tick of the game, after the script's.</summary>
    public void Tick()
    {
        Milliseconds += 1000 / TicksPerSecond;
        GameFrame++;
        if (!IsFrozen)
        {
            State++;
            _ticksToFreeze -= _wantsFrozen ? 1 : 0;
        }

        _shown.Add(State);
    }

    public CameraState ReadCamera()
    {
        OnCall(nameof(ReadCamera));
        long state = CameraReportedLate ? StateAgo(1) : State;
        return new CameraState(new Pose(new Vector3D(0, state * MetresPerTick, 1.5), Axes.Identity), 50, 0.15, 4.0 / 3);
    }

    public EgoState ReadEgo()
    {
        OnCall(nameof(ReadEgo));
        return new EgoState(7, "blista", new Pose(new Vector3D(0, State * MetresPerTick, 0), Axes.Identity), new Vector3D(0, 15, 0));
    }

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range)
    {
        OnCall(nameof(ReadEntities));
        var car = new EntityState(
            101,
            ObjectClass.Car,
            "asea",
            new Pose(new Vector3D(2, (State * MetresPerTick * 1.5) + 12, 0.6), Axes.Identity),
            new Vector3D(-1, -2.3, -0.6),
            new Vector3D(1, 2.3, 0.9),
            new Vector3D(0, 22, 0)
        );
        return _read = Entities([car]);
    }

    public EnvironmentState ReadEnvironment()
    {
        OnCall(nameof(ReadEnvironment));
        return new EnvironmentState("clear", TimeSpan.FromHours(12));
    }

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        OnCall(nameof(Cast));
        Milliseconds += MillisecondsPerRay;
        return Rays is null ? FirstCuboid(ray, maxDistance) : Rays(ray, maxDistance, ignoredEntity);
    }

    public GrabResult Grab(PixelBuffer target)
    {
        OnCall(nameof(Grab));
        long state = StateAgo(PictureLag);
        BitConverter.GetBytes(state).CopyTo(target.Bytes, 0);
        target.Bytes.AsSpan(8, MovementBytes).Fill((byte)(state * 37));
        target.Bytes[^1] = (byte)(GameFrame % 2 * Noise);
        return GrabAnswer;
    }

    public void Freeze()
    {
        OnCall(nameof(Freeze));
        if (!_wantsFrozen)
        {
            _wantsFrozen = true;
            _ticksToFreeze = FreezeDelay;
        }
    }

    public void Unfreeze()
    {
        OnCall(nameof(Unfreeze));
        _wantsFrozen = false;
    }

    private RayHit? FirstCuboid(Ray ray, double maxDistance)
    {
        RayHit? first = null;
        foreach (EntityState entity in _read)
        {
            if (
                Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose).Intersect(ray) is { } span
                && span.Entry <= Math.Min(maxDistance, first?.Distance ?? maxDistance)
            )
            {
                first = new RayHit(span.Entry, entity.Handle);
            }
        }

        return first;
    }

    private long StateAgo(int ticks) => _shown[Math.Max(0, _shown.Count - 1 - ticks)];
}
