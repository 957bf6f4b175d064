using Harvester.Datasets.Files;

namespace Harvester.Datasets.Outputs;

/// <summary>
/// Looks for the finished result of a command that is to be resumed, under the lock of its folder: a run that was killed at its very end
/// has left its own, which goes with this one.
/// </summary>
public static class FinishedResult
{
    /// <summary>What is found.</summary>
    /// <typeparam name="T">Its type.</typeparam>
    /// <param name="folder">The folder.</param>
    /// <param name="find">Looks for it.</param>
    /// <exception cref="OccupiedFolderException">Another process is writing to the folder.</exception>
    public static T Of<T>(string folder, Func<T> find)
    {
        using FolderLock held = FolderLock.Take(folder);
        return find();
    }
}
