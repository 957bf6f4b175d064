using GTA.Math;
using GTA.Native;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>The game's vehicles, by its natives.</summary>
internal sealed class GameVehicles : IVehicles
{
    /// <inheritdoc/>
    public int OfPlayer => Natives.VehicleOf(Natives.PlayerPed());

    /// <inheritdoc/>
    public bool Exists(int vehicle) => Natives.EntityExists(vehicle);

    /// <inheritdoc/>
    public int MakeBesidePlayer(int model, double metresBeside)
    {
        int player = Natives.PlayerPed();
        Vector3 place = Natives.Call<Vector3>(Hash.GET_OFFSET_FROM_ENTITY_IN_WORLD_COORDS, player, (float)metresBeside, 0f, 0f);
        float heading = Natives.Call<float>(Hash.GET_ENTITY_HEADING, player);

        // Whether it exists is not checked: if the check failed, the vehicle would be unknown and never removed.
        return Natives.Call<int>(Hash.CREATE_VEHICLE, model, place.X, place.Y, place.Z, heading, false, false, false);
    }

    /// <inheritdoc/>
    public void Prepare(int vehicle, int primaryColour, int secondaryColour, string plate)
    {
        Natives.PlaceOnGround(vehicle);
        Natives.Call(Hash.SET_ENTITY_INVINCIBLE, vehicle, true);
        Natives.Call(Hash.SET_VEHICLE_ENGINE_CAN_DEGRADE, vehicle, false);
        Natives.Call(Hash.SET_DISABLE_VEHICLE_PETROL_TANK_DAMAGE, vehicle, true);
        Natives.Call(Hash.SET_VEHICLE_TYRES_CAN_BURST, vehicle, false);
        Natives.Call(Hash.SET_VEHICLE_CAN_BE_VISIBLY_DAMAGED, vehicle, false);
        Natives.Call(Hash.SET_VEHICLE_WHEELS_CAN_BREAK, vehicle, false);
        Natives.Call(Hash.SET_VEHICLE_COLOURS, vehicle, primaryColour, secondaryColour);
        Natives.Call(Hash.SET_VEHICLE_NUMBER_PLATE_TEXT, vehicle, plate);
    }

    /// <inheritdoc/>
    public void Remove(int vehicle) => Natives.Delete(vehicle, Hash.DELETE_VEHICLE);
}
