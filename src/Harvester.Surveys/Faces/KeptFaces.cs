using System.Collections.Generic;
using System.Linq;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Surveys.Faces;

/// <summary>Faces of a model that a survey leaves as they were known: rays cannot tell what is painted on a plate's back.</summary>
internal static class KeptFaces
{
    /// <summary>
    /// The faces of a sign that a survey found, and after them those that it could not find: the known ones to whose side none of the found
    /// ones looks, if they were measured before, or look another way than the model's first. Heads of lights are found by their bones, all
    /// of them, and none is kept. A kept face keeps its number where that is free.
    /// </summary>
    /// <param name="found">What was found, at least one face.</param>
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

    /// <summary>The least number that no face has.</summary>
    public static int FreeNumber(IReadOnlyCollection<ModelFace> faces) =>
        Enumerable.Range(0, faces.Count + 1).First(number => faces.All(face => face.Number != number));
}
