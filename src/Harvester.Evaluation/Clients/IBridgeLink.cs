using System;
using Harvester.Capture.Ports;

namespace Harvester.Evaluation.Clients;

/// <summary>The far end of a bridge to a game.</summary>
public interface IBridgeLink : IDisposable
{
    /// <summary>Whether what is said may never be heard, so that it has to be said again.</summary>
    bool MayLose { get; }

    /// <summary>Waits for the newest frame that has not been given yet.</summary>
    /// <param name="patience">How long.</param>
    /// <returns>Null when there was none.</returns>
    /// <exception cref="System.IO.IOException">The bridge is gone, or what comes over it is no frame.</exception>
    ClientFrame? Receive(TimeSpan patience);

    /// <summary>Answers a frame.</summary>
    /// <exception cref="System.IO.IOException">The bridge is gone.</exception>
    void Send(DrivingControls controls, long frame);

    /// <summary>Asks for a frame of the world as it is.</summary>
    /// <exception cref="System.IO.IOException">The bridge is gone.</exception>
    void AskForFrame();

    /// <summary>Lets the world go on for so long and stop then.</summary>
    /// <exception cref="System.IO.IOException">The bridge is gone.</exception>
    void Step(double seconds);
}
