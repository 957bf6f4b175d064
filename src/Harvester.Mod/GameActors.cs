using GTA.Native;
using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>Entities of staged actors and the game's tasks, by its natives.</summary>
internal sealed class GameActors : IActorGame
{
    private const int DriversSeat = -1;

    /// <summary>The game's number of civilian men, as a type of peds.</summary>
    private const int Civilian = 4;

    /// <summary>The game's number of braking hard until the time is over.</summary>
    private const int BrakeHard = 27;

    private const float StopRangeMetres = 2;

    /// <summary>A driver goes straight to a place within this distance, metres, instead of along the lanes.</summary>
    private const float StraightMetres = 1000;
    private const int RightIndicator = 0;
    private const int LeftIndicator = 1;

    /// <inheritdoc/>
    public int Player => Natives.PlayerPed();

    /// <inheritdoc/>
    public int PlayersVehicle => Natives.VehicleOf(Natives.PlayerPed());

    /// <inheritdoc/>
    public bool HasModel(int model) => Natives.ModelExists(model);

    /// <inheritdoc/>
    public bool IsInView(Vector3D middle, double radius) =>
        Natives.Call<bool>(Hash.IS_SPHERE_VISIBLE, (float)middle.X, (float)middle.Y, (float)middle.Z, (float)radius);

    // What is made is not touched here: if that failed, its handle would be lost and it would never be removed.

    /// <inheritdoc/>
    public int MakeVehicle(int model, Vector3D ground, double headingDegrees) =>
        Natives.Call<int>(
            Hash.CREATE_VEHICLE,
            model,
            (float)ground.X,
            (float)ground.Y,
            (float)ground.Z,
            (float)headingDegrees,
            false,
            false,
            false
        );

    /// <inheritdoc/>
    public int MakeDriver(int model, int vehicle) =>
        Natives.Call<int>(Hash.CREATE_PED_INSIDE_VEHICLE, vehicle, Civilian, model, DriversSeat, false, false);

    /// <inheritdoc/>
    public int MakePed(int model, Vector3D ground, double headingDegrees) =>
        Natives.Call<int>(
            Hash.CREATE_PED,
            Civilian,
            model,
            (float)ground.X,
            (float)ground.Y,
            (float)ground.Z,
            (float)headingDegrees,
            false,
            false
        );

    /// <inheritdoc/>
    public void PlaceOnGround(int vehicle) => Natives.PlaceOnGround(vehicle);

    /// <inheritdoc/>
    public void Calm(int ped) => Natives.Call(Hash.SET_BLOCKING_OF_NON_TEMPORARY_EVENTS, ped, true);

    /// <inheritdoc/>
    public int MakeThing(int model, Vector3D ground) =>
        Natives.Call<int>(Hash.CREATE_OBJECT_NO_OFFSET, model, (float)ground.X, (float)ground.Y, (float)ground.Z, false, false, false);

    /// <inheritdoc/>
    public bool Exists(int entity) => Natives.EntityExists(entity);

    /// <inheritdoc/>
    public void DeleteVehicle(int vehicle) => Natives.Delete(vehicle, Hash.DELETE_VEHICLE);

    /// <inheritdoc/>
    public void DeletePed(int ped) => Natives.Delete(ped, Hash.DELETE_PED);

    /// <inheritdoc/>
    public void DeleteThing(int thing) => Natives.Delete(thing, Hash.DELETE_OBJECT);

    /// <inheritdoc/>
    public Pose PoseOf(int entity) => Natives.EntityPose(entity);

    /// <inheritdoc/>
    public Vector3D VelocityOf(int entity) => Natives.EntityVelocity(entity);

    /// <inheritdoc/>
    public void SetForwardSpeed(int vehicle, double speed) => Natives.Call(Hash.SET_VEHICLE_FORWARD_SPEED, vehicle, (float)speed);

    /// <inheritdoc/>
    public void DriveTo(int driver, int vehicle, Vector3D place, double speed, int style)
    {
        const int unused = 0;
        Natives.Call(
            Hash.TASK_VEHICLE_DRIVE_TO_COORD,
            driver,
            vehicle,
            (float)place.X,
            (float)place.Y,
            (float)place.Z,
            (float)speed,
            unused,
            Natives.EntityModel(vehicle),
            style,
            StopRangeMetres,
            StraightMetres
        );
    }

    /// <inheritdoc/>
    public void SetCruiseSpeed(int driver, double speed) => Natives.Call(Hash.SET_DRIVE_TASK_CRUISE_SPEED, driver, (float)speed);

    /// <inheritdoc/>
    public void Brake(int driver, int vehicle, int milliseconds) =>
        Natives.Call(Hash.TASK_VEHICLE_TEMP_ACTION, driver, vehicle, BrakeHard, milliseconds);

    /// <inheritdoc/>
    public void WalkTo(int ped, Vector3D place, double gait)
    {
        // Never put there at once, whatever heading at the end, and no sliding.
        const int neverTeleported = -1;
        const float anyHeading = 40_000;
        Natives.Call(
            Hash.TASK_GO_STRAIGHT_TO_COORD,
            ped,
            (float)place.X,
            (float)place.Y,
            (float)place.Z,
            (float)gait,
            neverTeleported,
            anyHeading,
            0f
        );
    }

    /// <inheritdoc/>
    public void ClearTasks(int ped) => Natives.Call(Hash.CLEAR_PED_TASKS, ped);

    /// <inheritdoc/>
    public void SetDoor(int vehicle, int door, bool isOpen)
    {
        if (isOpen)
        {
            Natives.Call(Hash.SET_VEHICLE_DOOR_OPEN, vehicle, door, false, false);
        }
        else
        {
            Natives.Call(Hash.SET_VEHICLE_DOOR_SHUT, vehicle, door, false);
        }
    }

    /// <inheritdoc/>
    public void SetIndicators(int vehicle, bool left, bool right)
    {
        Natives.Call(Hash.SET_VEHICLE_INDICATOR_LIGHTS, vehicle, LeftIndicator, left);
        Natives.Call(Hash.SET_VEHICLE_INDICATOR_LIGHTS, vehicle, RightIndicator, right);
    }
}
