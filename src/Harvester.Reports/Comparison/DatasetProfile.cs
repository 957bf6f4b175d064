using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Reports.Comparison;

/// <summary>The distributions of a dataset.</summary>
/// <param name="name">Name for people; any text.</param>
public sealed class DatasetProfile(string name)
{
    /// <summary>No size, distance or angle of an image is as large.</summary>
    private const double MaxMagnitude = 1e9;

    private readonly Dictionary<ComparedQuantity, ValueSketch> _values = ComparedQuantity.All.ToDictionary(
        quantity => quantity,
        _ => new ValueSketch()
    );

    /// <summary>Name for people; any text.</summary>
    public string Name => name;

    /// <summary>Number of frames: images with their labels.</summary>
    public long Frames => Of(ComparedQuantity.ObjectsPerFrame).Count;

    /// <summary>Number of labels of objects in all frames.</summary>
    public long Labels => Classes.Count;

    /// <summary>Labels by class.</summary>
    public CategoryCounts Classes { get; } = new();

    /// <summary>Labels by level of occlusion or visibility.</summary>
    public CategoryCounts Levels { get; } = new();

    /// <summary>Labels by KITTI's type; empty if the dataset cannot say.</summary>
    public CategoryCounts KittiTypes { get; } = new();

    /// <summary>The distribution of a quantity; empty if the dataset lacks it.</summary>
    public ValueSketch Of(ComparedQuantity quantity) => _values[quantity];

    /// <exception cref="DatasetFormatException">A number is impossible, or there are too many classes.</exception>
    internal void Add(ComparedObject item)
    {
        Classes.Add(item.Class);
        Levels.Add(item.Level);
        if (item.KittiType is { } type)
        {
            KittiTypes.Add(type);
        }

        Add(ComparedQuantity.BoxHeight, item.Box.Height);
        Add(ComparedQuantity.BoxWidth, item.Box.Width);
        Add(ComparedQuantity.BoxArea, item.Box.Area);
        Add(ComparedQuantity.Distance, item.DistanceMetres);
        Add(ComparedQuantity.Truncation, item.TruncatedFraction);
        Add(ComparedQuantity.Occlusion, item.OccludedFraction);
        Add(ComparedQuantity.Orientation, item.ObservationRadians is { } angle ? Angles.ToDegrees(Angles.WrapRadians(angle)) : null);
    }

    internal void AddFrame(int objects) => Of(ComparedQuantity.ObjectsPerFrame).Add(objects);

    private void Add(ComparedQuantity quantity, double? value)
    {
        if (value is not { } known)
        {
            return;
        }

        if (!(Math.Abs(known) <= MaxMagnitude))
        {
            throw new DatasetFormatException(
                FormattableString.Invariant(
                    $"{Name}: {quantity.Title.ToLowerInvariant()} of a label is {known}; {MaxMagnitude} is the limit."
                )
            );
        }

        Of(quantity).Add(known);
    }
}
