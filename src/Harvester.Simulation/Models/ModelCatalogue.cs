using Harvester.Geometry;

namespace Harvester.Simulation.Models;

/// <summary>All models of the simulated game.</summary>
public sealed class ModelCatalogue
{
    private static readonly Lazy<ModelCatalogue> LazyShared = new(() => new ModelCatalogue());

    private readonly Dictionary<string, Model> _byName;

    private ModelCatalogue()
    {
        Vehicles = VehicleModels.All().ToArray();
        Pedestrians = PedestrianModels.All().ToArray();
        Signs = SignModels.All().ToArray();
        TrafficLights = SignalModels.All().ToArray();
        StreetLamp = StreetModels.StreetLamp();
        Bench = StreetModels.Bench();
        Trees = StreetModels.Trees().ToArray();
        _byName = ((IEnumerable<Model>)[.. Vehicles, .. Pedestrians, .. Signs, .. TrafficLights, StreetLamp, Bench, .. Trees]).ToDictionary(
            model => model.Name,
            StringComparer.Ordinal
        );
    }

    /// <summary>One catalogue for all worlds; models are immutable.</summary>
    public static ModelCatalogue Shared => LazyShared.Value;

    /// <summary>Vehicles with the sizes of the game's models, in several colours.</summary>
    public IReadOnlyList<Model> Vehicles { get; }

    /// <summary>People of several builds and clothes; the variants are postures, with their joints.</summary>
    public IReadOnlyList<Model> Pedestrians { get; }

    /// <summary>Traffic signs, whose faces look towards -y of the model.</summary>
    public IReadOnlyList<Model> Signs { get; }

    /// <summary>Traffic lights, whose lenses look towards -y of the model; the variants are the states.</summary>
    public IReadOnlyList<Model> TrafficLights { get; }

    /// <summary>A street lamp; its arm extends towards -x of the model.</summary>
    public Model StreetLamp { get; }

    /// <summary>A bench; who sits on it looks along +y.</summary>
    public Model Bench { get; }

    /// <summary>Position of the lamp's light, in the frame of <see cref="StreetLamp"/>.</summary>
    public static Vector3D StreetLampHead => StreetModels.LampHead;

    /// <summary>Trees of several kinds, each in several sizes.</summary>
    public IReadOnlyList<Model> Trees { get; }

    /// <summary>The model with a name.</summary>
    /// <exception cref="KeyNotFoundException">There is no such model.</exception>
    public Model this[string name] =>
        _byName.TryGetValue(name, out Model? model) ? model : throw new KeyNotFoundException($"The simulated game has no model '{name}'.");
}
