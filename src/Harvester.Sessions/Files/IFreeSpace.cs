namespace Harvester.Sessions.Files;

/// <summary>How much can still be written to a disk.</summary>
public interface IFreeSpace
{
    /// <summary>The space that this user may still fill on the disk of a folder, bytes; null if the system does not say.</summary>
    /// <param name="folder">The folder.</param>
    long? BytesFor(string folder);
}
