using System;
using System.Collections.Generic;
using System.IO;
using Harvester.Datasets.Files;
using Harvester.Datasets.Images;
using Harvester.Datasets.Masks.Pixels;
using Harvester.Datasets.Sessions;
using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Exports;

/// <summary>One frame on its way into a dataset.</summary>
public sealed class ExportFrame
{
    private readonly SessionReader _session;
    private readonly ObjectSelector _selector;
    private InstanceMap? _mask;
    private InstanceMap? _dividedMask;
    private IReadOnlyDictionary<int, InstancePixels>? _pixels;
    private IReadOnlyDictionary<int, InstancePixels>? _dividedPixels;
    private FrameSelection? _selection;

    internal ExportFrame(SessionReader session, LabelLine line, ObjectSelector selector, ImageFormat? format)
    {
        _session = session;
        _selector = selector;
        Label = line.Label!;
        LabelText = line.Text;
        ImageExtension = format?.Extension() ?? Path.GetExtension(Label.Image);
    }

    /// <summary>Number of the frame in the dataset, from 0: the sessions' frames one after the other.</summary>
    public required int Index { get; init; }

    /// <summary>Number of its session, from 0.</summary>
    public required int SessionIndex { get; init; }

    /// <summary>Number of the frame in its session, from 0.</summary>
    public required int FrameInSession { get; init; }

    /// <summary>Its split.</summary>
    public required string Split { get; init; }

    /// <summary>The camera of the session's first frame.</summary>
    public required CameraLabel SessionCamera { get; init; }

    /// <summary>Its label, all objects included.</summary>
    public FrameLabel Label { get; }

    /// <summary>The line of labels.jsonl that it was read from.</summary>
    public string LabelText { get; }

    /// <summary>Eight digits that name the frame in the dataset.</summary>
    public string Name => FormattableString.Invariant($"{Index:D8}");

    /// <summary>End of the exported image's name, with the dot: .png, .bmp or .jpg.</summary>
    public string ImageExtension { get; }

    /// <summary>Whether the image is exported in another format than its session keeps it in.</summary>
    public bool IsImageConverted => ImageExtension != Path.GetExtension(Label.Image);

    /// <summary>Where the image lies.</summary>
    public string ImagePath => PathOf(Label.Image);

    /// <summary>Reads the image.</summary>
    /// <exception cref="DatasetFormatException">It is missing or damaged.</exception>
    public PixelBuffer ReadImage()
    {
        try
        {
            return PictureReader.Read(ImagePath);
        }
        catch (DatasetFormatException e)
        {
            throw Problem($"the image '{Label.Image}' cannot be read: {e.Message}");
        }
    }

    /// <summary>Where the mask lies; null without one.</summary>
    public string? MaskPath => Label.Mask is null ? null : PathOf(Label.Mask);

    /// <summary>The instance mask, read when it is first asked for; null when the session has none.</summary>
    /// <exception cref="DatasetFormatException">The mask is missing, damaged or of another size than the image.</exception>
    public InstanceMap? Mask => MaskPath is null ? null : _mask ??= ReadMask(MaskPath);

    /// <summary>The instance mask in which faces and heads have pixels of their own; null when the session has none.</summary>
    /// <exception cref="DatasetFormatException">As of <see cref="Mask"/>.</exception>
    internal InstanceMap? DividedMask => Mask is { } mask ? _dividedMask ??= PartPixels.Divide(mask, Label) : null;

    /// <summary>The objects to export, by rising id.</summary>
    internal IReadOnlyList<ExportObject> Objects => Selection.Objects;

    /// <summary>Regions with something that is not exported.</summary>
    internal IReadOnlyList<ExportRegion> Ignored => Selection.Ignored;

    /// <summary>The image, pixels.</summary>
    internal Box2D Image => new(0, 0, Label.Camera.Width, Label.Camera.Height);

    private FrameSelection Selection => _selection ??= _selector.Of(this);

    /// <summary>Whether a label is the post of faces or heads that are the objects.</summary>
    internal bool IsPost(ObjectLabel label) => _selector.IsPost(label, this);

    /// <summary>
    /// The pixels of an object or a part; null when none is seen or the session has no masks. Those of an object include its parts'.
    /// </summary>
    /// <exception cref="DatasetFormatException">As of <see cref="Mask"/>.</exception>
    internal InstancePixels? PixelsOf(ObjectLabel label)
    {
        if (Mask is null)
        {
            return null;
        }

        return label.Parent is null
            ? (_pixels ??= InstancePixels.AllOf(Mask)).GetValueOrDefault(label.Id)
            : (_dividedPixels ??= InstancePixels.AllOf(DividedMask!)).GetValueOrDefault(label.Id);
    }

    /// <summary>A problem with this frame, with the place where it is.</summary>
    public DatasetFormatException Problem(string message) => new($"{_session.Folder}, frame {Label.Frame}: {message}");

    private string PathOf(string name) =>
        _session.IsWithin(name) ? _session.PathOf(name) : throw Problem($"'{name}' points out of the session.");

    private InstanceMap ReadMask(string path)
    {
        try
        {
            InstanceMap mask = PngDecoder.ReadInstanceMap(path);
            return mask.Image.Width == Label.Camera.Width && mask.Image.Height == Label.Camera.Height
                ? mask
                : throw new DatasetFormatException("its size is not that of the image.");
        }
        catch (DatasetFormatException e)
        {
            throw Problem($"the mask '{Label.Mask}' cannot be used: {e.Message}");
        }
    }
}
