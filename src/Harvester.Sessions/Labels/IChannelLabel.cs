namespace Harvester.Sessions.Labels;

/// <summary>What a channel says of a frame in its label.</summary>
public interface IChannelLabel
{
    /// <summary>Paths of its files within the session, with forward slashes.</summary>
    IEnumerable<string> Files { get; }
}
