using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Harvester.Datasets.Json;
using Harvester.Datasets.Validation;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Exports.Validation;

/// <summary>What must hold for COCO instances: ids are unique and known, images are there, boxes lie in them.</summary>
internal static class CocoCheck
{
    private const string Prefix = "instances_";

    /// <summary>Boxes are rounded to three decimals.</summary>
    private const double RoundingPixels = 0.01;

    public static IEnumerable<SessionProblem> Problems(string folder) =>
        Directory.EnumerateFiles(Path.Combine(folder, "annotations"), Prefix + "*.json").Order(StringComparer.Ordinal).SelectMany(file => ProblemsOf(folder, file));

    private static SessionProblem[] ProblemsOf(string folder, string file)
    {
        string name = Path.GetRelativePath(folder, file);
        try
        {
            using JsonDocument document = JsonDocument.Parse(File.ReadAllBytes(file));
            string images = $"images/{Path.GetFileNameWithoutExtension(file)[Prefix.Length..]}";
            return [.. Messages(folder, images, new JsonFields(document.RootElement)).Select(message => new SessionProblem(name, null, message))];
        }
        catch (Exception e) when (e is JsonException or DatasetFormatException)
        {
            return [new SessionProblem(name, null, e.Message)];
        }
    }

    private static IEnumerable<string> Messages(string folder, string imageFolder, JsonFields coco)
    {
        var images = new Dictionary<long, ImageSize>();
        foreach (JsonFields image in coco.List("images"))
        {
            images[image.LargeWholeNumber("id")] = new ImageSize(image.WholeNumber("width"), image.WholeNumber("height"));
            if (!File.Exists(Path.Combine(folder, imageFolder, image.Text("file_name"))))
            {
                yield return $"image '{image.Text("file_name")}' is not in {imageFolder}.";
            }
        }

        HashSet<int> categories = [.. coco.List("categories").Select(category => category.WholeNumber("id"))];
        var ids = new HashSet<long>();
        foreach (JsonFields annotation in coco.List("annotations"))
        {
            if (Problem(annotation, images, categories, ids) is { } problem)
            {
                yield return $"annotation {annotation.LargeWholeNumber("id")}: {problem}";
            }
        }
    }

    private static string? Problem(JsonFields annotation, Dictionary<long, ImageSize> images, HashSet<int> categories, HashSet<long> ids)
    {
        if (!images.TryGetValue(annotation.LargeWholeNumber("image_id"), out ImageSize image))
        {
            return "its image is not listed.";
        }

        double[] box = annotation.Numbers("bbox", 4);
        bool isBox = box[0] >= 0 && box[1] >= 0 && box[2] > 0 && box[3] > 0
            && box[0] + box[2] <= image.Width + RoundingPixels && box[1] + box[3] <= image.Height + RoundingPixels;
        return !ids.Add(annotation.LargeWholeNumber("id")) ? "its id is there twice."
            : !categories.Contains(annotation.WholeNumber("category_id")) ? "its category is not listed."
            : isBox ? null : $"its box does not lie in the image of {image.Width} x {image.Height}.";
    }
}
