using Harvester.Datasets.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Validation;

/// <summary>Checks that an exported dataset is complete and that its labels follow their format.</summary>
public static class DatasetValidator
{
    /// <summary>Whether a folder is a finished dataset.</summary>
    public static bool IsDataset(string folder) => new DatasetFolder(folder).IsFinished;

    /// <summary>Whether a folder has an unfinished export.</summary>
    public static bool IsUnfinished(string folder) => new DatasetFolder(folder).IsBegun;

    /// <summary>Validates a dataset.</summary>
    /// <param name="folder">The folder of the dataset.</param>
    /// <param name="cancellation">Stops between two images.</param>
    /// <exception cref="DatasetFormatException">export.json is invalid.</exception>
    public static DatasetValidation Validate(string folder, CancellationToken cancellation = default)
    {
        DatasetHeader header = DatasetHeader.Read(folder);
        var dataset = new DatasetContent(folder, header.Options);
        var problems = new ProblemList();
        foreach (SessionProblem problem in ImageProblems(folder).Concat(header.Format.Check(dataset)))
        {
            cancellation.ThrowIfCancellationRequested();
            problems.Add(problem);
            if (problems.IsFull)
            {
                break;
            }
        }

        foreach ((string split, int counted) in header.FramesOfSplits)
        {
            int found = dataset.FramesOfSplits.GetValueOrDefault(split);
            if (found != counted)
            {
                problems.Add(
                    new SessionProblem(
                        DatasetFolder.Header,
                        null,
                        $"it counts {Counted.Of(counted, "frame")} in {split}, but the dataset has {found}."
                    )
                );
            }
        }

        var manifest = new DatasetManifestCheck(folder, header.Files);
        manifest.AddProblems(problems, cancellation);
        return new DatasetValidation(header.Format.Name, dataset.FramesOfSplits.Values.Sum(), problems)
        {
            HasManifest = manifest.IsThere,
            OtherFiles = manifest.OtherFiles,
        };
    }

    private static IEnumerable<SessionProblem> ImageProblems(string folder)
    {
        IEnumerable<string> images = Directory
            .EnumerateFiles(folder, "*", SearchOption.AllDirectories)
            .Where(file => Path.GetExtension(file) is ".png" or ".bmp" or ".jpg")
            .Order(StringComparer.Ordinal);
        foreach (string image in images)
        {
            if (Damage(image) is { } damage)
            {
                yield return new SessionProblem(Path.GetRelativePath(folder, image).Replace('\\', '/'), null, damage);
            }
        }
    }

    private static string? Damage(string image)
    {
        try
        {
            _ = ImageHeader.Read(image);
            return null;
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }
    }
}
