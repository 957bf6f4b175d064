using Harvester.Geometry.Cameras;
using Harvester.Geometry.Motion;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Formats.Flow;

/// <summary>The forward flow of a frame: of the pixels of the frame before, to the frame.</summary>
/// <param name="image">The size of both images.</param>
/// <param name="vectors">Three numbers a pixel, as in docs/flow.md.</param>
/// <param name="flags">What is known of each pixel.</param>
internal sealed class PairFlow(ImageSize image, ushort[] vectors, ushort[] flags)
{
    /// <summary>The size of both images, pixels.</summary>
    public ImageSize Image => image;

    /// <summary>Reads the maps of a frame.</summary>
    /// <exception cref="DatasetFormatException">A map is missing, damaged or of another size than the image.</exception>
    public static PairFlow Of(ExportFrame frame, FlowLabel flow)
    {
        try
        {
            ushort[] vectors = PngDecoder.ReadDeepColour(frame.PathOf(flow.Maps.Forward));
            InstanceMap flags = PngDecoder.ReadLabelMap(frame.PathOf(flow.Maps.ForwardFlags));
            return
                (flags.Image.Width, flags.Image.Height) == (frame.Label.Camera.Width, frame.Label.Camera.Height)
                && vectors.Length == 3 * flags.Ids.Length
                ? new PairFlow(flags.Image, vectors, flags.Ids)
                : throw new DatasetFormatException("its size is not that of the image.");
        }
        catch (DatasetFormatException e)
        {
            throw frame.Problem($"the map of flow '{flow.Maps.Forward}' or its flags cannot be used: {e.Message}");
        }
    }

    /// <summary>Whether the flow of a pixel is known.</summary>
    public bool IsKnown(int pixel) => (FlagsAt(pixel) & FlowFlags.Valid) != 0;

    /// <summary>Whether the flow of a pixel is known and its point is also seen in the second image.</summary>
    public bool IsVisible(int pixel) =>
        (FlagsAt(pixel) & (FlowFlags.Valid | FlowFlags.Covered | FlowFlags.LeavesPicture)) == FlowFlags.Valid;

    /// <summary>Whether the surface moved by itself.</summary>
    public bool HasMoved(int pixel) => (FlagsAt(pixel) & FlowFlags.Moved) != 0;

    /// <summary>A number of a pixel of known flow: to the right and down, as <see cref="FlowUnits"/>.</summary>
    public (ushort Right, ushort Down) NumbersAt(int pixel) => (vectors[3 * pixel], vectors[(3 * pixel) + 1]);

    private FlowFlags FlagsAt(int pixel) => (FlowFlags)flags[pixel];
}
