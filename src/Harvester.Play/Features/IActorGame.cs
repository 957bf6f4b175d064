using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>What staged actors need of the game, besides <see cref="IModels"/>: entities of their own, and the game's tasks.</summary>
public interface IActorGame
{
    /// <summary>The player's body.</summary>
    int Player { get; }

    /// <summary>The vehicle of the player; 0 if there is none.</summary>
    int PlayersVehicle { get; }

    /// <summary>Whether the game has a model.</summary>
    bool HasModel(int model);

    /// <summary>Whether the camera sees a part of a sphere, whatever stands before it.</summary>
    bool IsInView(Vector3D middle, double radius);

    /// <summary>Makes a vehicle of a loaded model; 0 if the game has no room.</summary>
    int MakeVehicle(int model, Vector3D ground, double headingDegrees);

    /// <summary>Makes a person of a loaded model on the driver's seat of a vehicle; 0 if the game has no room.</summary>
    int MakeDriver(int model, int vehicle);

    /// <summary>Makes a person or animal of a loaded model; 0 if the game has no room.</summary>
    int MakePed(int model, Vector3D ground, double headingDegrees);

    /// <summary>Makes a thing of a loaded model; 0 if the game has no room.</summary>
    int MakeThing(int model, Vector3D ground);

    /// <summary>Puts a vehicle on all its wheels.</summary>
    void PlaceOnGround(int vehicle);

    /// <summary>Lets a person neither flee nor fight when something happens, so that it keeps to its tasks.</summary>
    void Calm(int ped);

    /// <summary>Whether an entity exists.</summary>
    bool Exists(int entity);

    /// <summary>Deletes a vehicle that a script made.</summary>
    void DeleteVehicle(int vehicle);

    /// <summary>Deletes a person or animal that a script made.</summary>
    void DeletePed(int ped);

    /// <summary>Deletes a thing that a script made.</summary>
    void DeleteThing(int thing);

    /// <summary>The pose of an entity.</summary>
    Pose PoseOf(int entity);

    /// <summary>The velocity of an entity, m/s, world.</summary>
    Vector3D VelocityOf(int entity);

    /// <summary>Gives a vehicle a speed in its direction, m/s.</summary>
    void SetForwardSpeed(int vehicle, double speed);

    /// <summary>Lets a driver drive to a place.</summary>
    /// <param name="driver">The driver.</param>
    /// <param name="vehicle">The vehicle.</param>
    /// <param name="place">The place, metres, world.</param>
    /// <param name="speed">m/s.</param>
    /// <param name="style">The game's flags of how to drive.</param>
    void DriveTo(int driver, int vehicle, Vector3D place, double speed, int style);

    /// <summary>Changes the speed for which a driver aims, m/s.</summary>
    void SetCruiseSpeed(int driver, double speed);

    /// <summary>Lets a driver brake and stand for a time, milliseconds.</summary>
    void Brake(int driver, int vehicle, int milliseconds);

    /// <summary>Lets a person walk straight to a place.</summary>
    /// <param name="ped">The person.</param>
    /// <param name="place">The place, metres, world.</param>
    /// <param name="gait">1 walks, 2 runs, 3 sprints.</param>
    void WalkTo(int ped, Vector3D place, double gait);

    /// <summary>Lets a person or driver do nothing.</summary>
    void ClearTasks(int ped);

    /// <summary>Opens or closes a door of a vehicle.</summary>
    /// <param name="vehicle">The vehicle.</param>
    /// <param name="door">0 for the left front door, 1 for the right one.</param>
    /// <param name="isOpen">Whether it is to be open.</param>
    void SetDoor(int vehicle, int door, bool isOpen);

    /// <summary>Switches the indicators of a vehicle.</summary>
    void SetIndicators(int vehicle, bool left, bool right);
}
