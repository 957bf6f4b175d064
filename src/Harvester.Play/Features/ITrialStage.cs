using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>A stage on which actors appear over ticks, as trials with scenarios use it.</summary>
public interface ITrialStage : IStage
{
    /// <summary>Whether every actor that was asked for is in the world, or gone again.</summary>
    bool AreAllThere { get; }

    /// <summary>The game's handle of an actor's vehicle, body or thing; 0 while it is not there.</summary>
    /// <param name="handle">Handle of the actor on this stage.</param>
    int EntityOf(int handle);

    /// <summary>Gives a vehicle a forward speed at once.</summary>
    /// <param name="handle">Handle of the actor on this stage; 0 for the player's vehicle.</param>
    /// <param name="speed">Metres per second.</param>
    void Launch(int handle, double speed);

    /// <summary>Takes all actors out of the world and gives the player's vehicle back.</summary>
    void Clear();
}
