using System;
using System.Collections.Generic;
using System.Linq;

namespace Harvester.Simulation.Models;

/// <summary>All models of the simulated game. Making one builds every mesh, so share it.</summary>
public sealed class ModelCatalogue
{
    private readonly Dictionary<string, Model> _byName;

    /// <summary>Builds all models.</summary>
    public ModelCatalogue()
    {
        Vehicles = VehicleModels.All().ToArray();
        _byName = Vehicles.ToDictionary(model => model.Name, StringComparer.Ordinal);
    }

    /// <summary>Vehicles with the sizes of the game's models, in several colours.</summary>
    public IReadOnlyList<Model> Vehicles { get; }

    /// <summary>The model of a name.</summary>
    /// <exception cref="KeyNotFoundException">There is no such model.</exception>
    public Model this[string name] => _byName.TryGetValue(name, out Model? model)
        ? model
        : throw new KeyNotFoundException($"The simulated game has no model '{name}'.");
}
