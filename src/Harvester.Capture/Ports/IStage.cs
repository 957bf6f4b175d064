namespace Harvester.Capture.Ports;

/// <summary>
/// Puts actors into a game's world and gives them orders. An order replaces the one before it and holds until it is done; whatever then
/// happens is read from the world as always. All calls come from the game's own thread.
/// </summary>
public interface IStage
{
    /// <summary>Puts an actor into the world; it stands until it gets an order, or rolls on at its initial speed.</summary>
    /// <param name="actor">What is put where.</param>
    /// <returns>Its handle, or why it cannot be there.</returns>
    StageSpawn Spawn(StageActor actor);

    /// <summary>Sends an actor along a path.</summary>
    /// <param name="handle">Handle of the actor.</param>
    /// <param name="order">Where and how fast.</param>
    void Follow(int handle, StageOrder order);

    /// <summary>Changes the speed of an actor on its path.</summary>
    /// <param name="handle">Handle of the actor.</param>
    /// <param name="speed">The new speed, m/s; 0 or more.</param>
    /// <param name="acceleration">How fast it is reached, m/s²; more than 0, also for braking.</param>
    void SetSpeed(int handle, double speed, double acceleration);

    /// <summary>Opens or closes the door of a vehicle.</summary>
    /// <param name="handle">Handle of the vehicle.</param>
    /// <param name="side">Side of the door, -1 left or 1 right.</param>
    /// <param name="isOpen">Whether it is to be open.</param>
    void SetDoor(int handle, int side, bool isOpen);

    /// <summary>Switches the indicators of a vehicle.</summary>
    /// <param name="handle">Handle of the vehicle.</param>
    /// <param name="indicators">Which blink.</param>
    void SetIndicators(int handle, StageIndicators indicators);

    /// <summary>Takes an actor out of the world. One that is gone already is skipped.</summary>
    /// <param name="handle">Handle of the actor.</param>
    void Remove(int handle);

    /// <summary>The state of an actor.</summary>
    /// <param name="handle">Handle of the actor.</param>
    /// <returns>Null if it is gone.</returns>
    StageState? StateOf(int handle);

    /// <summary>Sends the ego, under the game's own driver, along the lanes that a path lies on.</summary>
    /// <param name="order">Where and how fast; the driver obeys lights and others unless the order says otherwise.</param>
    void DriveEgo(StageOrder order);
}
