using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Runs.Evaluation.Figures;

namespace Harvester.Runs.Clients;

/// <summary>Drives over a bridge: the controller answers each new frame.</summary>
/// <param name="link">The link to the game.</param>
/// <param name="newController">Creates the controller; called again when the car has been teleported.</param>
/// <param name="patience">Real time to wait for a frame.</param>
/// <param name="clock">Real time.</param>
public sealed class ClientDriver(IBridgeLink link, Func<IController> newController, TimeSpan patience, TimeProvider clock)
{
    private static readonly TimeSpan Look = TimeSpan.FromMilliseconds(100);

    /// <summary>
    /// After this time without a frame, the last message may be lost, or the game is slow. A requested frame tells: if the answer was lost,
    /// the world has not moved.
    /// </summary>
    private static readonly TimeSpan AskAfter = TimeSpan.FromSeconds(2);

    private IController _controller = newController();
    private ClientFrame? _last;
    private long _heard;
    private long _spoke;
    private bool _isAsking;
    private DrivingControls _answer;

    /// <summary>Number of frames answered.</summary>
    public long Frames { get; private set; }

    /// <summary>Time driven, seconds of game time.</summary>
    public double Seconds { get; private set; }

    /// <summary>Distance driven, integrated from the speed, metres.</summary>
    public double Metres { get; private set; }

    /// <summary>Whether the game has closed the bridge.</summary>
    public bool IsEndedByGame { get; private set; }

    /// <summary>Drives until it is stopped, the time is over or the game closes the bridge.</summary>
    /// <param name="stepSeconds">Game time by which each answer advances the world, which waits for the controller; null if the world runs
    /// by itself.</param>
    /// <param name="seconds">Time limit, seconds of game time.</param>
    /// <param name="cancellation">Stops the drive.</param>
    /// <exception cref="IOException">The bridge fails, or no frame arrives for too long.</exception>
    public void Run(double? stepSeconds, double seconds, CancellationToken cancellation)
    {
        _heard = _spoke = clock.GetTimestamp();
        try
        {
            while (!cancellation.IsCancellationRequested && Seconds < seconds)
            {
                ClientFrame? frame = link.Receive(Look);
                if (frame is not null && frame.TimeSeconds != _last?.TimeSeconds)
                {
                    Take(frame);
                    Answer(stepSeconds);
                    Frames++;
                    _heard = _spoke;
                }
                else if (clock.GetElapsedTime(_heard) > patience)
                {
                    throw new IOException(
                        FormattableString.Invariant($"No frame has arrived from the game for {patience.TotalSeconds} s.")
                    );
                }
                else if (frame is not null && _isAsking)
                {
                    Answer(stepSeconds);
                }
                else if (link.MayLose && (_last is null || stepSeconds is not null) && clock.GetElapsedTime(_spoke) > AskAfter)
                {
                    link.AskForFrame();
                    _isAsking = true;
                    _spoke = clock.GetTimestamp();
                }
            }
        }
        catch (BridgeEndedException) when (Frames > 0)
        {
            IsEndedByGame = true;
        }
    }

    private void Take(ClientFrame frame)
    {
        // After a restart of the game, its time begins again.
        double passed = Math.Max(0, frame.TimeSeconds - (_last?.TimeSeconds ?? frame.TimeSeconds));
        double speed = frame.State.SpeedMetresPerSecond;
        if (
            _last?.Position is { } before
            && frame.Position is { } now
            && Relocation.Is((now - before).Length, _last.State.SpeedMetresPerSecond, speed, passed)
        )
        {
            _controller = newController();
        }

        Seconds += passed;
        Metres += speed * passed;
        _last = frame;
        _answer = _controller.Drive(frame.State);
    }

    private void Answer(double? stepSeconds)
    {
        link.Send(_answer, _last!.Frame);
        if (stepSeconds is { } step)
        {
            link.Step(step);
        }

        _isAsking = false;
        _spoke = clock.GetTimestamp();
    }
}
