using Harvester.Capture.Ports;

namespace Harvester.Simulation.Models;

/// <summary>The models of staged actors: by the name of a model, or by that of a class, of which the actor's number chooses one.</summary>
internal static class StageModels
{
    private static readonly Dictionary<string, string[]> Classes = new(StringComparer.Ordinal)
    {
        ["car"] = ["asea", "asterope", "fugitive", "premier", "primo", "stanier", "surge", "oracle", "blista", "landstalker"],
        ["van"] = ["speedo", "pony"],
        ["truck"] = ["biff", "stockade", "packer"],
        ["lorry"] = ["boxville", "stockade"],
        ["bus"] = ["pbus"],
        ["motorcycle"] = ["akuma", "bati"],
        ["bicycle"] = ["scorcher", "bmx"],
        ["police"] = ["police2", "police3"],
        ["fireEngine"] = ["firetruk"],
    };

    private static readonly Lazy<IReadOnlyDictionary<string, Model>> Things = new(() =>
        ThingModels.All().ToDictionary(model => model.Name, StringComparer.Ordinal)
    );

    /// <summary>The names of classes of models.</summary>
    public static IEnumerable<string> ClassNames => Classes.Keys;

    /// <summary>The model of an actor; null if there is none.</summary>
    public static Model? Find(ModelCatalogue catalogue, StageActor actor)
    {
        int number = actor.Number & int.MaxValue;
        if (actor.Kind == StageKind.Pedestrian && actor.Model == "pedestrian")
        {
            return catalogue.Pedestrians[number % catalogue.Pedestrians.Count];
        }

        string name = Classes.TryGetValue(actor.Model, out string[]? names) ? names[number % names.Length] : actor.Model;
        if (ThingModels.NameOf(name) is { } known && Things.Value.TryGetValue(known, out Model? thing))
        {
            return thing;
        }

        IReadOnlyList<Model> among = actor.Kind == StageKind.Pedestrian ? catalogue.Pedestrians : catalogue.Vehicles;
        return among.FirstOrDefault(model => model.Name == name);
    }
}
