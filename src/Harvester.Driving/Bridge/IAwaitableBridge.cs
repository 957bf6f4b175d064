namespace Harvester.Driving.Bridge;

/// <summary>A bridge whose messages can be waited for, for a game that does nothing without them.</summary>
public interface IAwaitableBridge : IDrivingBridge
{
    /// <summary>Number of clients that have disconnected or been replaced, also of those that were there only for a moment.</summary>
    int ClientsGone { get; }

    /// <summary>Waits until <see cref="IClientInbox.TryReceive"/> has a message.</summary>
    /// <param name="patience">Maximum time to wait, 0 or more.</param>
    /// <returns>Whether there is a message.</returns>
    bool AwaitMessage(TimeSpan patience);
}
