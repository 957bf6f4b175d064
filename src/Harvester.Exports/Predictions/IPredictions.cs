using Harvester.Datasets.Detections;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Predictions;

/// <summary>Predictions in one of the formats, with the ground truth as the export of that format has it.</summary>
internal interface IPredictions
{
    /// <summary>Name of the format.</summary>
    string Format { get; }

    /// <summary>Classes that a prediction can have.</summary>
    IReadOnlyList<PredictedClass> Classes { get; }

    /// <summary>Added to x and y, moves a box of the format to the pixels of a session.</summary>
    double ToSessionPixels { get; }

    /// <summary>The number of the image of a frame; null if the export does not label that frame.</summary>
    int? ImageOf(ExportFrame frame);

    /// <summary>The ground truth of a frame.</summary>
    IEnumerable<TruthObject> TruthOf(ExportFrame frame);

    /// <summary>The predictions for an image, in the order of their file.</summary>
    /// <exception cref="DatasetFormatException">They are missing or malformed.</exception>
    IReadOnlyList<PredictedBox> For(int image);

    /// <summary>Checks that no predictions are for other images.</summary>
    /// <exception cref="DatasetFormatException">There are others.</exception>
    void CheckImages(IReadOnlySet<int> images);
}
