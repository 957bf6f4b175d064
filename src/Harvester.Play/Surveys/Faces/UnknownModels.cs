using Harvester.Geometry;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Play.Surveys.Faces;

/// <summary>Collects the models of signs, lights and props of unknown class that were seen and that a table lacks.</summary>
/// <param name="table">Returns the currently known faces.</param>
public sealed class UnknownModels(Func<FaceTable> table)
{
    private readonly Func<FaceTable> _table = table ?? throw new ArgumentNullException(nameof(table));
    private readonly SortedDictionary<string, (ObjectClass Class, Vector3D Place)> _met = new(StringComparer.Ordinal);

    /// <summary>The models seen so far, by name.</summary>
    public IReadOnlyCollection<string> Models => [.. _met.Keys.Where(IsUnknown)];

    /// <summary>Examines the entities of one moment.</summary>
    public void Look(IEnumerable<EntityState> entities)
    {
        foreach (
            EntityState entity in entities.Where(entity =>
                entity.Class is ObjectClass.Sign or ObjectClass.TrafficLight or ObjectClass.Other
            )
        )
        {
            if (!_met.ContainsKey(entity.Model) && IsUnknown(entity.Model))
            {
                _met.Add(entity.Model, (entity.Class, entity.Pose.Position));
            }
        }
    }

    /// <summary>Writes a header and a line for each model: name, hash, class, and where it was first seen (metres, world).</summary>
    public void Write(TextWriter text)
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        text.Write("model,hash,class,x,y,z\n");
        foreach (KeyValuePair<string, (ObjectClass Class, Vector3D Place)> met in _met.Where(met => IsUnknown(met.Key)))
        {
            (ObjectClass kind, Vector3D place) = met.Value;
            text.Write(FormattableString.Invariant($"{met.Key},{HashOf(met.Key)},{JsonName.Of(kind)},"));
            text.Write(
                string.Join(",", new[] { place.X, place.Y, place.Z }.Select(value => InvariantNumber.Format(value, LabelDecimals.Metres)))
                    + "\n"
            );
        }
    }

    private bool IsUnknown(string model) => _table().Of(HashOf(model)).Count == 0;

    private static int HashOf(string model) => ModelHash.TryParse(model, out int hash) ? hash : ModelHash.Of(model);
}
