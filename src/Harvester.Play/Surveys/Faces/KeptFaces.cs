using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Surveys.Faces;

/// <summary>The faces of a model that a survey keeps: rays cannot find what is painted on the back of a plate.</summary>
internal static class KeptFaces
{
    /// <summary>
    /// The faces of a sign that a survey found, followed by those that it could not find: the known faces on a side where none was found,
    /// if they were measured before, or look in another direction than the model's first. All heads of lights are found by their bones, and
    /// none is kept. A kept face keeps its number if that is free.
    /// </summary>
    /// <param name="found">The faces found, at least one.</param>
    /// <param name="known">The model's faces as known before.</param>
    public static IReadOnlyList<ModelFace> BesideFound(IReadOnlyList<ModelFace> found, IReadOnlyList<ModelFace> known)
    {
        List<ModelFace> all = [.. found];
        if (found[0].Class == ObjectClass.Sign)
        {
            foreach (ModelFace face in known.Where(face => face.Provenance == Provenance.Measured || face.Facing != known[0].Facing))
            {
                if (found.All(other => other.Facing != face.Facing))
                {
                    all.Add(all.Any(other => other.Number == face.Number) ? face with { Number = FreeNumber(all) } : face);
                }
            }
        }

        return all;
    }

    /// <summary>The smallest number that no face has.</summary>
    public static int FreeNumber(IReadOnlyCollection<ModelFace> faces) =>
        Enumerable.Range(0, faces.Count + 1).First(number => faces.All(face => face.Number != number));
}
