using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Datasets.Exports.Coco;
using Harvester.Datasets.Exports.Csv;
using Harvester.Datasets.Exports.Kitti;
using Harvester.Datasets.Exports.Voc;
using Harvester.Datasets.Exports.Yolo;

namespace Harvester.Datasets.Exports;

/// <summary>The formats that can be exported; each has a page in docs/exports.</summary>
public static class DatasetFormats
{
    /// <summary>All of them, in the order in which help lists them.</summary>
    public static IReadOnlyList<DatasetFormat> All { get; } =
    [
        new("kitti", "KITTI object detection: image_2, label_2, calib", _ => new KittiWriter()) { NeedsRectilinear = true },
        new("coco", "COCO instances", options => new CocoWriter(options)),
        new("yolo", "Ultralytics YOLO, boxes", options => new YoloWriter(options)),
        new("yolo-segment", "Ultralytics YOLO, outlines", options => new YoloSegmentWriter(options)) { NeedsMasks = true },
        new("voc", "Pascal VOC", options => new VocWriter(options)),
        new("csv", "Flat tables of frames and objects", _ => new CsvDatasetWriter()),
    ];

    /// <summary>A format by its name, or null.</summary>
    public static DatasetFormat? Find(string name) => All.FirstOrDefault(format => string.Equals(format.Name, name, StringComparison.Ordinal));
}
