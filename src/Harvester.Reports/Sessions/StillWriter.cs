using Harvester.Datasets.Colours;
using Harvester.Datasets.Files;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Reports.Drawing;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Reports.Sessions;

/// <summary>
/// Draws a frame of a session with its 2D and 3D boxes, in the colours of the classes. Boxes of occluded objects are fainter. Of
/// signs and lights, faces and heads are drawn, and their posts only if asked for.
/// </summary>
public static class StillWriter
{
    private const int Black = 0;
    private const double BoxWidth = 2;
    private const double OutlineWidth = 4;
    private const double OutlineOpacity = 0.45;
    private const double EdgeWidth = 1;
    private const double EdgeOpacity = 0.6;

    /// <summary>How much fainter the box of a fully occluded object is, as a fraction.</summary>
    private const double HiddenFading = 0.7;

    /// <summary>Writes the image as PNG.</summary>
    /// <param name="session">The session.</param>
    /// <param name="frame">The frame number.</param>
    /// <param name="path">The file to write.</param>
    /// <param name="showsPosts">Whether the posts of signs and lights are drawn too.</param>
    /// <exception cref="DatasetFormatException">There is no such frame, or it cannot be read.</exception>
    /// <exception cref="IOException">A file cannot be read or written.</exception>
    public static void Write(SessionReader session, int frame, string path, bool showsPosts = false)
    {
        FrameLabel label = LabelOf(session, frame);
        PixelBuffer picture = ReadPicture(session, label.Image);
        var canvas = new LineCanvas(picture);
        Camera camera = LabelCamera.Of(label.Camera);

        // Sorted by distance, farthest first, so that the nearest is on top.
        foreach (
            ObjectLabel item in label
                .Objects.Where(item => showsPosts || !Posts.Has(item, label))
                .OrderByDescending(item => item.DistanceMetres)
        )
        {
            int colour = ClassColours.Of(item.Class);
            double opacity = 1 - (HiddenFading * (item.OccludedFraction ?? 0));
            foreach ((Vector2D start, Vector2D end) in CuboidEdges.Of(camera, item.Box3D))
            {
                canvas.Line(start, end, EdgeWidth, colour, EdgeOpacity * opacity);
            }

            canvas.Rectangle(item.Box2D, OutlineWidth, Black, OutlineOpacity * opacity);
            canvas.Rectangle(item.Box2D, BoxWidth, colour, opacity);
        }

        OutputFile.Write(path, file => new PngEncoder().Write(picture, file));
    }

    private static FrameLabel LabelOf(SessionReader session, int frame)
    {
        FrameLabel? last = null;
        foreach (FrameLabel label in session.ReadLabels())
        {
            if (label.Frame == frame)
            {
                return label;
            }

            last = label;
        }

        string end = last is null ? "It is empty." : $"Its last frame is {last.Frame}.";
        throw new DatasetFormatException($"'{session.Folder}' has no frame {frame}. {end}");
    }

    private static PixelBuffer ReadPicture(SessionReader session, string image)
    {
        try
        {
            return PictureReader.Read(session.PathOf(image));
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{image} cannot be drawn on: {e.Message}", e);
        }
    }
}
