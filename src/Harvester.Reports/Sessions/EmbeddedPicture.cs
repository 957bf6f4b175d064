namespace Harvester.Reports.Sessions;

/// <summary>A picture as a report holds it.</summary>
/// <param name="MediaType">image/jpeg, or the type of the file where that cannot be decoded.</param>
/// <param name="Bytes">The file.</param>
internal readonly record struct EmbeddedPicture(string MediaType, byte[] Bytes);
