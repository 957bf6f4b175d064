using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>The game's models, by the hashes of their names.</summary>
public interface IModels
{
    /// <summary>Whether the game has the model, and it is a vehicle.</summary>
    bool IsVehicle(int model);

    /// <summary>Asks the game to load a model; to be called repeatedly until it has.</summary>
    /// <returns>Whether it is loaded.</returns>
    bool Load(int model);

    /// <summary>Lets the game unload a model that was requested.</summary>
    void Release(int model);

    /// <summary>
    /// Corners of a model's box in its own frame: rear, left, lower and front, right, upper; metres. They are not symmetric.
    /// </summary>
    (Vector3D Min, Vector3D Max) DimensionsOf(int model);

    /// <summary>Number of a vehicle's class in the game.</summary>
    int VehicleClassOf(int vehicle);

    /// <summary>The name that the game displays for a vehicle's model.</summary>
    string DisplayNameOf(int model);
}
