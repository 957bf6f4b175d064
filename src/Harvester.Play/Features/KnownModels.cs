using System.Globalization;
using Harvester.Geometry;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>The facts of the models seen so far; each is read from the game once.</summary>
/// <param name="models">The game's models.</param>
/// <param name="table">The models of signs and traffic lights.</param>
public sealed class KnownModels(IModels models, FaceTable table)
{
    private readonly Dictionary<int, ModelFacts> _known = [];

    /// <summary>A vehicle's model.</summary>
    /// <param name="vehicle">The vehicle's handle.</param>
    /// <param name="hash">The model's hash.</param>
    public ModelFacts OfVehicle(int vehicle, int hash) =>
        Find(hash, () => (VehicleClasses.Of(hash, models.VehicleClassOf(vehicle)), NameOfVehicle(hash)));

    /// <summary>A person's model, by its hash.</summary>
    public ModelFacts OfPed(int hash) => Find(hash, () => (ObjectClass.Pedestrian, Hexadecimal(hash)));

    /// <summary>A prop's model, by its hash.</summary>
    public ModelFacts OfProp(int hash) =>
        Find(
            hash,
            () =>
            {
                IReadOnlyList<ModelFace> faces = table.Of(hash);
                return faces.Count == 0
                    ? SurveyedModels.UnnamedBy(hash) is { } name
                        ? (ObjectClass.Sign, name)
                        : (ObjectClass.Other, Hexadecimal(hash))
                    : (faces[0].Class, faces[0].Model.Length > 0 ? faces[0].Model : Hexadecimal(hash));
            }
        );

    private static string Hexadecimal(int hash) => "0x" + hash.ToString("X8", CultureInfo.InvariantCulture);

    // The displayed name is the model's own for most vehicles; its hash shows whether it is.
    private string NameOfVehicle(int hash)
    {
        string displayed = models.DisplayNameOf(hash);
        return !string.IsNullOrEmpty(displayed) && ModelHash.Of(displayed) == hash ? displayed.ToLowerInvariant() : Hexadecimal(hash);
    }

    private ModelFacts Find(int hash, Func<(ObjectClass Class, string Name)> describe)
    {
        if (_known.TryGetValue(hash, out ModelFacts? known))
        {
            return known;
        }

        (ObjectClass objectClass, string name) = describe();
        (Vector3D min, Vector3D max) = models.DimensionsOf(hash);
        return _known[hash] = new ModelFacts(objectClass, name, min, max);
    }
}
