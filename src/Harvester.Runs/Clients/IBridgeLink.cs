using Harvester.Capture.Ports;

namespace Harvester.Runs.Clients;

/// <summary>The client's side of a bridge to a game.</summary>
public interface IBridgeLink : IDisposable
{
    /// <summary>Whether messages may be lost, so that they must be repeated.</summary>
    bool MayLose { get; }

    /// <summary>Waits for the newest frame that has not been returned yet.</summary>
    /// <param name="patience">Time to wait.</param>
    /// <returns>The frame; null if none arrived.</returns>
    /// <exception cref="System.IO.IOException">The bridge has failed, or a message is not a frame.</exception>
    ClientFrame? Receive(TimeSpan patience);

    /// <summary>Answers a frame.</summary>
    /// <exception cref="System.IO.IOException">The bridge has failed.</exception>
    void Send(DrivingControls controls, long frame);

    /// <summary>Requests a frame of the current state of the world.</summary>
    /// <exception cref="System.IO.IOException">The bridge has failed.</exception>
    void AskForFrame();

    /// <summary>Lets the world run for a time and then freeze.</summary>
    /// <exception cref="System.IO.IOException">The bridge has failed.</exception>
    void Step(double seconds);
}
