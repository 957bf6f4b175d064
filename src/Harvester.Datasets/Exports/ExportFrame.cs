using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Harvester.Capture.Labels;
using Harvester.Datasets.Images;
using Harvester.Datasets.Sessions;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Exports;

/// <summary>One frame on its way into a dataset.</summary>
public sealed class ExportFrame
{
    private readonly SessionReader _session;
    private InstanceMap? _mask;

    internal ExportFrame(SessionReader session, LabelLine line, ExportOptions options)
    {
        _session = session;
        Label = line.Label!;
        LabelText = line.Text;
        Objects = [.. Label.Objects.Where(options.Includes)];
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

    /// <summary>The objects to export, by rising id.</summary>
    public IReadOnlyList<ObjectLabel> Objects { get; }

    /// <summary>Eight digits that name the frame in the dataset.</summary>
    public string Name => FormattableString.Invariant($"{Index:D8}");

    /// <summary>End of the image's name, with the point: .png or .bmp.</summary>
    public string ImageExtension => Path.GetExtension(Label.Image);

    /// <summary>Where the image lies.</summary>
    public string ImagePath => PathOf(Label.Image);

    /// <summary>Where the mask lies; null without one.</summary>
    public string? MaskPath => Label.Mask is null ? null : PathOf(Label.Mask);

    /// <summary>The instance mask, read when it is first asked for; null when the session has none.</summary>
    /// <exception cref="DatasetFormatException">The mask is missing, damaged or of another size than the image.</exception>
    public InstanceMap? Mask => MaskPath is null ? null : _mask ??= ReadMask(MaskPath);

    /// <summary>A problem with this frame, with the place where it is.</summary>
    public DatasetFormatException Problem(string message) => new($"{_session.Folder}, frame {Label.Frame}: {message}");

    private string PathOf(string name) =>
        SessionReader.IsWithin(name) ? _session.PathOf(name) : throw Problem($"'{name}' points out of the session.");

    private InstanceMap ReadMask(string path)
    {
        try
        {
            InstanceMap mask = PngDecoder.ReadInstanceMap(path);
            return mask.Image.Width == Label.Camera.Width && mask.Image.Height == Label.Camera.Height
                ? mask
                : throw new DatasetFormatException("it is of another size than the image.");
        }
        catch (DatasetFormatException e)
        {
            throw Problem($"the mask '{Label.Mask}' cannot be used: {e.Message}");
        }
    }
}
