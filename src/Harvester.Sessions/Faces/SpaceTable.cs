using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Faces;

/// <summary>The spaces of interest of all known models.</summary>
public sealed class SpaceTable
{
    private static readonly IReadOnlyList<SpaceOfInterest> None = [];
    private readonly Dictionary<int, IReadOnlyList<SpaceOfInterest>> _byHash;

    /// <summary>Makes a table.</summary>
    /// <exception cref="ArgumentException">Two spaces have the same model and face number.</exception>
    public SpaceTable(IEnumerable<SpaceOfInterest> spaces)
    {
        _byHash = spaces
            .GroupBy(space => space.Hash)
            .ToDictionary(group => group.Key, group => (IReadOnlyList<SpaceOfInterest>)group.OrderBy(space => space.Face).ToArray());
        if (_byHash.Values.Any(faces => faces.Select(space => space.Face).Distinct().Count() < faces.Count))
        {
            throw new ArgumentException("A face of a model stands in the table twice.", nameof(spaces));
        }
    }

    /// <summary>A table without rows.</summary>
    public static SpaceTable Empty { get; } = new([]);

    /// <summary>All spaces, ordered by model and face.</summary>
    public IEnumerable<SpaceOfInterest> Spaces => _byHash.Values
        .SelectMany(faces => faces)
        .OrderBy(space => space.Model, StringComparer.Ordinal)
        .ThenBy(space => space.Hash)
        .ThenBy(space => space.Face);

    /// <summary>The spaces of a model, in the order of their faces; none for a model that is not in the table.</summary>
    public IReadOnlyList<SpaceOfInterest> Of(int hash) => _byHash.TryGetValue(hash, out IReadOnlyList<SpaceOfInterest>? faces) ? faces : None;

    /// <summary>The spaces of a model by its name, or by its hash as 0xXXXXXXXX.</summary>
    public IReadOnlyList<SpaceOfInterest> Of(string model) => Of(ModelHash.TryParse(model, out int hash) ? hash : ModelHash.Of(model));

    /// <summary>This table with the models of another in place of its own: what a user has measured goes before what was shipped.</summary>
    public SpaceTable OverriddenBy(SpaceTable other)
    {
        if (other is null)
        {
            throw new ArgumentNullException(nameof(other));
        }

        return new SpaceTable(Spaces.Where(space => !other._byHash.ContainsKey(space.Hash)).Concat(other.Spaces));
    }
}
