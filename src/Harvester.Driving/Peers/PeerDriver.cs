using System;
using System.IO;
using System.Threading;
using Harvester.Capture.Driving.Controllers;

namespace Harvester.Driving.Peers;

/// <summary>Drives over a bridge: each new frame is answered by what the controller makes of it.</summary>
/// <param name="link">To the game.</param>
/// <param name="controller">Who drives.</param>
public sealed class PeerDriver(IPeerLink link, IController controller)
{
    private static readonly TimeSpan Patience = TimeSpan.FromMilliseconds(100);
    private double _lastSeconds = double.NegativeInfinity;

    /// <summary>Frames answered.</summary>
    public long Frames { get; private set; }

    /// <summary>Way of the car as its speed tells it, metres.</summary>
    public double Metres { get; private set; }

    /// <summary>Drives until it is stopped, the time is over or the bridge is gone.</summary>
    /// <param name="stepSeconds">Lets the world go on by so much with each answer, so that it waits for the controller; null where it goes its own way.</param>
    /// <param name="seconds">Of the game's time.</param>
    /// <param name="cancellation">Stops it.</param>
    public void Run(double? stepSeconds, double seconds, CancellationToken cancellation)
    {
        double? first = null;
        try
        {
            while (!cancellation.IsCancellationRequested && !(_lastSeconds - first >= seconds))
            {
                if (link.Receive(Patience) is not { } frame || frame.TimeSeconds == _lastSeconds)
                {
                    continue;
                }

                first ??= frame.TimeSeconds;
                Metres += Frames > 0 ? frame.State.SpeedMetresPerSecond * Math.Max(0, frame.TimeSeconds - _lastSeconds) : 0;
                _lastSeconds = frame.TimeSeconds;
                link.Send(controller.Drive(frame.State), frame.Frame);
                Frames++;
                if (stepSeconds is { } step)
                {
                    link.Step(step);
                }
            }
        }
        catch (IOException) when (Frames > 0)
        {
            // The game has ended the bridge; what was driven was driven.
            return;
        }
    }
}
