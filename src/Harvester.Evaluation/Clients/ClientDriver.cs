using System;
using System.IO;
using System.Threading;
using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Evaluation.Figures;

namespace Harvester.Evaluation.Clients;

/// <summary>Drives over a bridge: each new frame is answered by what the controller makes of it.</summary>
/// <param name="link">To the game.</param>
/// <param name="newController">Makes who drives; asked again when the car was put elsewhere.</param>
/// <param name="patience">For so long, on the clock, it waits for a frame.</param>
/// <param name="clock">The clock.</param>
public sealed class ClientDriver(IBridgeLink link, Func<IController> newController, TimeSpan patience, TimeProvider clock)
{
    private static readonly TimeSpan Look = TimeSpan.FromMilliseconds(100);

    /// <summary>
    /// What has no frame after it for so long may have been lost, or the game is slow. A frame is asked for: it tells which, for the world
    /// of a lost answer still stands where it stood.
    /// </summary>
    private static readonly TimeSpan AskAfter = TimeSpan.FromSeconds(2);

    private IController _controller = newController();
    private ClientFrame? _last;
    private long _heard;
    private long _spoke;
    private bool _isAsking;
    private DrivingControls _answer;

    /// <summary>Frames answered.</summary>
    public long Frames { get; private set; }

    /// <summary>Time driven, seconds of the game's.</summary>
    public double Seconds { get; private set; }

    /// <summary>Way of the car as its speed tells it, metres.</summary>
    public double Metres { get; private set; }

    /// <summary>Whether the game has closed the bridge.</summary>
    public bool IsEndedByGame { get; private set; }

    /// <summary>Drives until it is stopped, the time is over or the game closes the bridge.</summary>
    /// <param name="stepSeconds">Lets the world go on by so much with each answer, so that it waits for the controller; null where it goes
    /// its own way.</param>
    /// <param name="seconds">Of the game's time.</param>
    /// <param name="cancellation">Stops it.</param>
    /// <exception cref="IOException">The bridge has failed, or no frame has come for too long.</exception>
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
                        FormattableString.Invariant($"No frame has arrived from the game for {patience.TotalSeconds} s."));
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
        // A game that was started anew begins its time anew.
        double passed = Math.Max(0, frame.TimeSeconds - (_last?.TimeSeconds ?? frame.TimeSeconds));
        double speed = frame.State.SpeedMetresPerSecond;
        if (_last?.Position is { } before && frame.Position is { } now
            && Relocation.Is((now - before).Length, _last.State.SpeedMetresPerSecond, speed, passed))
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
