using Harvester.Sessions.Imaging;

namespace Harvester.Runs.Sheets;

/// <summary>A picture with its caption.</summary>
/// <param name="Picture">The picture as a harvest takes it.</param>
/// <param name="Caption">Place, weather, hour and how long the ego has driven.</param>
public sealed record SheetTile(PixelBuffer Picture, string Caption);
