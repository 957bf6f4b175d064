using GTA.Native;
using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>The game's models, by its natives.</summary>
internal sealed class GameModels : IModels
{
    /// <inheritdoc/>
    public bool IsVehicle(int model) => Natives.ModelExists(model) && Natives.Call<bool>(Hash.IS_MODEL_A_VEHICLE, model);

    /// <inheritdoc/>
    public bool Load(int model)
    {
        Natives.Call(Hash.REQUEST_MODEL, model);
        return Natives.Call<bool>(Hash.HAS_MODEL_LOADED, model);
    }

    /// <inheritdoc/>
    public void Release(int model) => Natives.Call(Hash.SET_MODEL_AS_NO_LONGER_NEEDED, model);

    /// <inheritdoc/>
    public (Vector3D Min, Vector3D Max) DimensionsOf(int model)
    {
        using var min = new NativeOutput();
        using var max = new NativeOutput();
        Natives.Call(Hash.GET_MODEL_DIMENSIONS, model, min, max);
        return (min.Vector, max.Vector);
    }

    /// <inheritdoc/>
    public int VehicleClassOf(int vehicle) => Natives.Call<int>(Hash.GET_VEHICLE_CLASS, vehicle);

    /// <inheritdoc/>
    public string DisplayNameOf(int model) => Natives.Call<string>(Hash.GET_DISPLAY_NAME_FROM_VEHICLE_MODEL, model);
}
