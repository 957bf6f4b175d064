using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Work;
using Harvester.Sessions.SelfTests;

namespace Harvester.Capture.SelfTests;

/// <summary>
/// Tests in a game what harvests rely on: call <see cref="Step"/> once in every tick, from the game's own thread, until it is over. A check
/// that fails is recorded as untested, and the others go on. Nothing is thrown to the caller. The game always ends up running, with
/// everything shown.
/// </summary>
public sealed class SelfTest : IDisposable
{
    private readonly SelfTestContext _context;
    private readonly SelfCheck[] _checks;
    private readonly WorkRun _run;
    private readonly int _pauseTicks;
    private int _current;

    /// <summary>Creates a self-test. The game is not used before the first step.</summary>
    /// <param name="options">The options of harvests: image, lens and picture lag.</param>
    /// <param name="game">The game. Its camera is mounted, and the ego stands or drives.</param>
    /// <param name="pauseTicks">Ticks between two checks, in which the world runs.</param>
    public SelfTest(HarvestOptions options, GamePorts game, int pauseTicks = 5)
    {
        _pauseTicks = pauseTicks;
        _context = new SelfTestContext(
            options ?? throw new ArgumentNullException(nameof(options)),
            game ?? throw new ArgumentNullException(nameof(game))
        );
        _checks =
        [
            new ColourCheck(_context),
            new FreezeCheck(_context, FreezeMethod.Paused),
            new FreezeCheck(_context, FreezeMethod.TimeScale),
            new CameraReportCheck(_context),
            new HudCheck(_context),
            new DisplayCheck(_context),
            new StillPictureCheck(_context),
            new MarkerCheck(_context),
            new LensCheck(_context),
            new HidingCheck(_context),
            new ShapeCheck(_context),
            new RayCheck(_context),
        ];
        _run = new WorkRun(Run());
    }

    /// <summary>Where it is.</summary>
    public SelfTestPhase Phase { get; private set; }

    /// <summary>Whether a picture is grabbed now or so soon that nothing may be drawn over it.</summary>
    public bool IsPictureNear { get; private set; } = true;

    /// <summary>What it does now, for the screen.</summary>
    public string Progress =>
        FormattableString.Invariant($"Self-test {Math.Min(_current + 1, _checks.Length)} of {_checks.Length}: ")
        + _checks[Math.Min(_current, _checks.Length - 1)].Title;

    /// <summary>The results, in the order of <see cref="SelfTestChecks.All"/>; complete at the end.</summary>
    public IReadOnlyList<SelfTestLine> Lines =>
        [.. SelfTestChecks.All.SelectMany(check => _context.Lines.Where(line => line.Check == check))];

    /// <summary>The pictures that show the results.</summary>
    public IReadOnlyList<SelfTestPicture> Pictures => _context.Pictures;

    /// <summary>The freeze method that is clearly better; null if they are equal, or neither stops the world.</summary>
    public FreezeMethod? ClearFreeze =>
        _context.Freezes is { Count: 2 } both && both.Count(IsSound) == 1 ? both.Single(IsSound).Method : null;

    /// <summary>The value of MaxPictureLagTicks that this game needs; null if the one in use is enough.</summary>
    public int? NeededLagTicks => _context.LagTicks is { } lag && lag > _context.Options.MaxPictureLagTicks ? lag : null;

    /// <summary>The lens that this game needs; null if the one in use is right, or it was not measured.</summary>
    public Lens? NeededLens => _context.MeasuredLens;

    /// <summary>Does the work of one tick. After the end it does nothing.</summary>
    public SelfTestPhase Step()
    {
        if (Phase == SelfTestPhase.Running && !_run.Advance())
        {
            Phase = SelfTestPhase.Done;
        }

        return Phase;
    }

    /// <summary>Stops: the game goes on, with everything shown.</summary>
    public void Dispose()
    {
        if (Phase == SelfTestPhase.Running)
        {
            Phase = SelfTestPhase.Stopped;
            _run.Dispose();
            _context.AddUntested(SelfTestChecks.All, "the self-test was stopped.");
        }
    }

    private static bool IsSound(FreezeFinding finding) => finding is { HoldsWorld: true, HoldsEnvironment: true, MovesCamera: not false };

    private IEnumerable<WorkStep> Run()
    {
        for (_current = 0; _current < _checks.Length; _current++)
        {
            SelfCheck check = _checks[_current];
            using var steps = new WorkRun(check.Run());
            try
            {
                while (Advance(check, steps))
                {
                    yield return WorkStep.Tick;
                }
            }
            finally
            {
                Release(check);
            }

            // The world runs for a moment between two checks, so that each begins with the same game.
            for (int tick = 0; tick < _pauseTicks; tick++)
            {
                IsPictureNear = tick + _context.PictureTicks >= _pauseTicks;
                yield return WorkStep.Tick;
            }
        }
    }

    private bool Advance(SelfCheck check, WorkRun steps)
    {
        try
        {
            return steps.Advance();
        }
#pragma warning disable CA1031 // The game's script loop must not see an exception of ours, whatever its type.
        catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
        {
            _context.AddUntested(check.Checks, exception.Message);
            return false;
        }
    }

    private void Release(SelfCheck check)
    {
        foreach (Action release in new Action[] { check.Release, Game.Pause.Unfreeze })
        {
            try
            {
                release();
            }
#pragma warning disable CA1031 // The rest must be released too.
            catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
            {
                _context.AddUntested(check.Checks, exception.Message);
            }
        }
    }

    private GamePorts Game => _context.Game;
}
