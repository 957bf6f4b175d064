using Harvester.Sessions.Reading.Files;

namespace Harvester.Reports.Comparison;

/// <summary>A dataset that can be compared.</summary>
public interface IComparedDataset
{
    /// <summary>Amount of work to read it.</summary>
    int Length { get; }

    /// <summary>Unit of the work, in the plural.</summary>
    string Unit { get; }

    /// <summary>Reads the labels into a profile.</summary>
    /// <param name="report">Receives the work done.</param>
    /// <param name="cancellation">Stops the reading.</param>
    /// <exception cref="DatasetFormatException">The dataset is malformed.</exception>
    /// <exception cref="System.IO.IOException">A file cannot be read.</exception>
    DatasetProfile Read(Action<int> report, CancellationToken cancellation);

    /// <summary>Evenly spaced images, found by <see cref="Read"/>; empty if the dataset has none.</summary>
    IReadOnlyList<string> Images { get; }
}
