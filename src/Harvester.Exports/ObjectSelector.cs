using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports;

/// <summary>Selects the objects of a frame to export, with their classes and boxes.</summary>
internal sealed class ObjectSelector(DatasetFormat format, ExportOptions options)
{
    private readonly ClassCatalogue _classes = new(options);

    /// <summary>Selects from a frame.</summary>
    public FrameSelection Of(ExportFrame frame)
    {
        var objects = new List<ExportObject>();
        var ignored = new List<ExportRegion>();
        IEnumerable<ObjectLabel> labels = format.IncludesRiders
            ? RiddenVehicles.WithRiders(frame.Label.Objects, frame.Label.Camera)
            : frame.Label.Objects;
        foreach (ObjectLabel label in labels.Where(label => IsThing(label, frame)))
        {
            DatasetClass? kind = format.IncludesRiders && label.Class == ObjectClass.Rider ? null : _classes.Of(label);
            Box2D? box = BoxOf(label, frame);
            if (kind is not null && box is { } exported && IsVisible(label, frame))
            {
                objects.Add(new ExportObject(label, kind, exported));
            }
            else if (box is not null || label.VisibleFraction is null)
            {
                ignored.Add(new ExportRegion(label.Class, kind, box ?? label.Box2D, label));
            }
        }

        ignored.AddRange(
            frame.Label.IgnoreRegions.Select(region => new ExportRegion(region.Class, _classes.Of(region.Class), region.Box2D, null))
        );
        return new FrameSelection(objects, ignored);
    }

    /// <summary>Whether a label is a post whose faces or heads are exported instead.</summary>
    public bool IsPost(ObjectLabel label, ExportFrame frame) => options.Parts == PartSelection.Faces && Posts.Has(label, frame.Label);

    private bool IsThing(ObjectLabel label, ExportFrame frame) =>
        options.Parts switch
        {
            PartSelection.None => label.Parent is null,
            PartSelection.Only => label.Parent is not null,
            PartSelection.Faces => !IsPost(label, frame),
            _ => true,
        };

    /// <summary>Visible pixels suffice if the occlusion is unknown, unless a visible fraction is required.</summary>
    private bool IsVisible(ObjectLabel label, ExportFrame frame) =>
        label.VisibleFraction is { } visible
            ? visible >= options.MinVisibleFraction
            : options.MinVisibleFraction == 0 && (format.KeepsUndetermined || VisibleBoxOf(label, frame) is not null);

    private Box2D? BoxOf(ObjectLabel label, ExportFrame frame) =>
        options.Boxes switch
        {
            BoxKind.Visible => VisibleBoxOf(label, frame),
            BoxKind.Whole => label.Parent is null ? label.Box2DWhole ?? VisibleBoxOf(label, frame) : label.Box2D,
            BoxKind.Amodal => format.HasBoxesBeyondImage ? label.Box2DAmodal : label.Box2DAmodal.Intersect(frame.Image),
            _ => label.Box2D,
        };

    private static Box2D? VisibleBoxOf(ObjectLabel label, ExportFrame frame) =>
        label.Parent is null ? label.Box2DVisible : frame.PixelsOf(label)?.Box;
}
