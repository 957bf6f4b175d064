using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.Coco;

/// <summary>Writes COCO keypoints: images by split, and an annotation file per split. See docs/exports/coco-keypoints.md.</summary>
internal sealed class CocoKeypointsWriter(ExportOptions options) : IDatasetWriter
{
    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string file = frame.Name + frame.ImageExtension;
        output.Image($"images/{frame.Split}/{file}", frame);
        output.Part($"images {frame.Split}", CocoJson.Image(frame, file));
        Camera camera = frame.Label.Camera.ToCamera();
        int objects = 0;
        int ignored = 0;
        foreach (ExportObject item in frame.Objects.Where(item => VehicleClasses.ArePeople(item.Label.Class)))
        {
            // With a mask, a person without visible pixels has nothing to annotate.
            var segmentation = new CocoSegmentation(SegmentationKind.Rle, frame.PixelsOf(item.Label));
            if (frame.Mask is null || segmentation.Area is not null)
            {
                bool hasJoints = item.Label.Joints is not null;
                output.Part($"annotations {frame.Split}", Annotation(frame, item.Label, camera, segmentation));
                objects += hasJoints ? 1 : 0;
                ignored += hasJoints ? 0 : 1;
            }
        }

        foreach (ExportRegion region in frame.Ignored.Where(region => VehicleClasses.ArePeople(region.Kind) && region.Class is not null))
        {
            int id = region.Label?.Id ?? CocoIds.FirstRegion + ignored;
            CocoSegmentation segmentation = CocoSegmentation.OfRegion(region, frame);
            output.Part($"annotations {frame.Split}", Line(frame, id, region.Box, segmentation, isCrowd: true, null, null));
            ignored++;
        }

        return new WrittenObjects(objects, ignored);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        CocoJson.Files("person_keypoints", options.Splits, "[" + CocoKeypoints.Category + "]");

    /// <summary>A person; one without joints has no keypoints, which evaluations ignore.</summary>
    private static string Annotation(ExportFrame frame, ObjectLabel label, Camera camera, CocoSegmentation segmentation)
    {
        Box2D box = label.Joints?.Box?.Intersect(frame.Image) ?? label.Box2D;
        IReadOnlyList<(double, double, int)>? keypoints = label.Joints is { } joints ? CocoKeypoints.Of(joints, camera) : null;
        return Line(frame, label.Id, box, segmentation, isCrowd: false, keypoints, label);
    }

    private static string Line(
        ExportFrame frame,
        int id,
        Box2D box,
        CocoSegmentation segmentation,
        bool isCrowd,
        IReadOnlyList<(double X, double Y, int Flag)>? keypoints,
        ObjectLabel? label
    ) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteNumber("id", CocoIds.Of(frame, id));
            json.WriteNumber("image_id", frame.Index);
            json.WriteNumber("category_id", 1);
            json.Numbers("bbox", [box.XMin, box.YMin, box.Width, box.Height], CocoJson.PixelDecimals);
            json.Number("area", segmentation.Area ?? box.Area, CocoJson.PixelDecimals);
            json.WriteNumber("iscrowd", isCrowd ? 1 : 0);
            json.WritePropertyName("segmentation");
            segmentation.Write(json);
            WriteKeypoints(json, keypoints ?? [.. Enumerable.Repeat((0.0, 0.0, CocoKeypoints.Absent), CocoKeypoints.Count)]);
            if (label is not null)
            {
                json.WriteNumber("track_id", label.Id);
                json.Number("distance_metres", label.DistanceMetres, CocoJson.PixelDecimals);
            }

            json.WriteEndObject();
        });

    private static void WriteKeypoints(Utf8JsonWriter json, IReadOnlyList<(double X, double Y, int Flag)> keypoints)
    {
        json.Numbers("keypoints", [.. keypoints.SelectMany(point => new[] { point.X, point.Y, point.Flag })], CocoJson.PixelDecimals);
        json.WriteNumber("num_keypoints", keypoints.Count(point => point.Flag != CocoKeypoints.Absent));
    }
}
