using System;
using System.Collections.Generic;
using System.Globalization;
using Harvester.Capture.Scenes;
using Harvester.Capture.Spaces;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>What is known of the models met so far; each is asked for once.</summary>
/// <param name="spaces">The models of signs and traffic lights.</param>
internal sealed class GameModels(SpaceTable spaces)
{
    private readonly Dictionary<int, ModelInfo> _known = [];

    public ModelInfo OfVehicle(int vehicle, int hash) =>
        Find(hash, () => (VehicleClasses.Of(hash, Natives.VehicleClass(vehicle)), NameOfVehicle(hash)));

    public ModelInfo OfPed(int hash) => Find(hash, () => (ObjectClass.Pedestrian, Hexadecimal(hash)));

    public ModelInfo OfProp(int hash) => Find(hash, () =>
    {
        IReadOnlyList<SpaceOfInterest> faces = spaces.Of(hash);
        return faces.Count == 0 ? (ObjectClass.Other, Hexadecimal(hash)) : (faces[0].Class, faces[0].Model.Length > 0 ? faces[0].Model : Hexadecimal(hash));
    });

    // The name that is displayed is the model's own for most vehicles; its hash tells which.
    private static string NameOfVehicle(int hash)
    {
        string displayed = Natives.VehicleDisplayName(hash);
        return !string.IsNullOrEmpty(displayed) && ModelHash.Of(displayed) == hash ? displayed.ToLowerInvariant() : Hexadecimal(hash);
    }

    private static string Hexadecimal(int hash) => "0x" + hash.ToString("X8", CultureInfo.InvariantCulture);

    private ModelInfo Find(int hash, Func<(ObjectClass Class, string Name)> describe)
    {
        if (_known.TryGetValue(hash, out ModelInfo? known))
        {
            return known;
        }

        (ObjectClass objectClass, string name) = describe();
        (Vector3D min, Vector3D max) = Natives.ModelDimensions(hash);
        return _known[hash] = new ModelInfo(objectClass, name, min, max);
    }
}
