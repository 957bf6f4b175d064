using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Paint;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Datasets.Roads;

/// <summary>Makes the images in which paint is looked for from the frames of a session.</summary>
internal sealed class PaintFrames(SessionReader session, PaintRoads roads)
{
    /// <summary>Pixels around a box that are hidden too: boxes of cuboids leave out mirrors and shadows' edges.</summary>
    private const double BoxMargin = 2;

    /// <summary>The values of a depth map are this many to the metre.</summary>
    private const float DepthUnitsPerMetre = 256;

    /// <summary>The image of a frame.</summary>
    /// <exception cref="DatasetFormatException">A file or the camera is invalid.</exception>
    public PaintImage Of(FrameLabel label)
    {
        Camera camera = LabelCamera.Of(label.Camera);
        byte[] rgb = Checked(
            label.Image,
            camera.Image,
            path => PictureReader.Read(path) is var picture ? (picture.Size, picture.Bytes) : default
        );
        byte[] hidden = Hidden(label, camera.Image);
        if (label.Depth?.Completed is { } completed)
        {
            ushort[] units = Map(completed, camera.Image);
            float[] depths = Array.ConvertAll(units, value => value / DepthUnitsPerMetre);
            return new PaintImage(camera, rgb, new DepthGround(camera, depths, hidden), hidden) { Depths = depths };
        }

        return new PaintImage(camera, rgb, Ground(label.Ego), hidden);
    }

    private RoadGround Ground(EgoLabel ego) =>
        ego.HeightAboveGroundMetres is { } height && ego.Axes is { } axes && roads.HeightAt(ego.Position) is { } road
            ? new RoadGround(ego.Position - new Vector3D(0, 0, height), axes, road)
            : new RoadGround();

    /// <summary>The pixels of labelled objects: those of the mask, or of the boxes without one; and of objects without a label.</summary>
    private byte[] Hidden(FrameLabel label, ImageSize size)
    {
        byte[] hidden = new byte[size.PixelCount];
        if (label.Mask is { } mask)
        {
            ushort[] ids = Map(mask, size);
            for (int i = 0; i < ids.Length; i++)
            {
                hidden[i] = ids[i] != 0 ? (byte)1 : (byte)0;
            }
        }
        else
        {
            foreach (ObjectLabel item in label.Objects)
            {
                Hide(hidden, size, item.Box2D);
            }
        }

        foreach (IgnoreRegion region in label.IgnoreRegions)
        {
            Hide(hidden, size, region.Box2D);
        }

        return hidden;
    }

    private static void Hide(byte[] hidden, ImageSize size, Box2D box)
    {
        int left = Math.Clamp((int)(box.XMin - BoxMargin), 0, size.Width);
        int right = Math.Clamp((int)Math.Ceiling(box.XMax + BoxMargin), left, size.Width);
        int bottom = Math.Clamp((int)Math.Ceiling(box.YMax + BoxMargin), 0, size.Height);
        for (int row = Math.Clamp((int)(box.YMin - BoxMargin), 0, size.Height); row < bottom; row++)
        {
            Array.Fill(hidden, (byte)1, (row * size.Width) + left, right - left);
        }
    }

    private ushort[] Map(string name, ImageSize size) =>
        Checked(name, size, path => PngDecoder.ReadInstanceMap(path) is var map ? (map.Image, map.Ids) : default);

    private T Checked<T>(string name, ImageSize size, Func<string, (ImageSize Size, T Content)> read)
    {
        string path = session.PathOf(name);
        try
        {
            (ImageSize actual, T content) = read(path);
            return actual == size ? content : throw new DatasetFormatException($"it has {actual} pixels, and its label {size}.");
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{path} cannot be read: {e.Message}", e);
        }
    }
}
